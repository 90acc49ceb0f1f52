// What every demo page loads: the elements, and the listings of their markup. Knows no particular
// page.
import 'phong-viewer';
import { showListings } from './parts/listings.js';

showListings(document);
