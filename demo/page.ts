// What does every demo page load? The elements, and the three features around them. Knows no particular page.
import 'phong-viewer';
import { connectDials } from './parts/dials.js';
import { linkViewers } from './parts/linked.js';
import { showListings } from './parts/listings.js';

showListings(document);
connectDials(document);
linkViewers(document);
