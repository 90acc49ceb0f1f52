// What `watchFirstPicture` leaves in a page.

interface Window {
  /** Milliseconds from navigation until the first picture was drawn. */
  firstPicture?: number;
}
