// What the bench's page shows within itself: the element alone in a document, so that it has the page's one context.
import '../../tests/bench/pages/field.js';
