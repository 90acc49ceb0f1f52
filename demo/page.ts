// What every demo page loads: the elements, and three small things built around them. Knows no page in particular.
import 'phong-viewer';
import { connectDials } from './parts/dials.js';
import { linkViewers } from './parts/linked.js';
import { showListings } from './parts/listings.js';

showListings(document);
connectDials(document);
linkViewers(document);
