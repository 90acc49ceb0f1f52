// What does every demo page load? The elements, and the two features around them. Knows no particular page.
import 'phong-viewer';
import { connectDials } from './parts/dials.js';
import { showListings } from './parts/listings.js';

showListings(document);
connectDials(document);
