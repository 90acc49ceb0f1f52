/** Ends the measurement once the GPU has drawn a canvas: the last one of its page. */
export function pictureIsThere(canvas: HTMLCanvasElement): void {
  const copy = document.createElement('canvas').getContext('2d')!;
  copy.drawImage(canvas, 0, 0);
  if (copy.getImageData(canvas.width / 2, canvas.height / 2, 1, 1).data[3] === 0) {
    throw new Error('no picture');
  }
  window.firstPicture = performance.now();
}
