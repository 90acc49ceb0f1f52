// What the measures leave in a page.

interface Window {
  /** Milliseconds from navigation until the first picture, or all of them, were drawn. */
  firstPicture?: number;
  /** The viewer has loaded its model; set by the page. */
  modelLoaded?: boolean;
}
