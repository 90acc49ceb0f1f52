// The 2D canvas that a capture is drawn into.

/** A 2D canvas of this size in pixels, transparent; null if the browser has no memory for it. */
export function newTarget(width: number, height: number): CanvasRenderingContext2D | null {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d');
  return context !== null && hasMemory(context, width, height) ? context : null;
}

/** Whether a canvas really has its pixels: browsers return canvases without memory, and only a drawn pixel shows it. */
function hasMemory(context: CanvasRenderingContext2D, width: number, height: number): boolean {
  if (context.canvas.width !== width || context.canvas.height !== height) return false;
  const corner = [width - 1, height - 1, 1, 1] as const;
  try {
    context.fillRect(...corner);
    const drawn = context.getImageData(...corner).data[3] === 255;
    context.clearRect(...corner);
    return drawn;
  } catch {
    return false;
  }
}
