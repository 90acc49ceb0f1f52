// Draws a display list into a picture file by Canvas 2D: an SVG image would need a `blob:` or
// `data:` address, which a strict CSP refuses. The same looks as svg-layer.ts.
import {
  coreOf,
  DASHES,
  type Disc,
  type DrawnItem,
  HALO,
  haloWidth,
  labelFont,
  type Stroke,
} from './display-list.js';

/**
 * A layer of this height in a picture file. `width` and `height` are the picture's in the layer's
 * pixels, `scale` how many of the picture's pixels are one of them.
 */
export function fileSize(
  picture: HTMLCanvasElement,
  layerHeight: number,
): { readonly width: number; readonly height: number; readonly scale: number } {
  const scale = layerHeight > 0 ? picture.height / layerHeight : 1;
  return { width: picture.width / scale, height: picture.height / scale, scale };
}

/**
 * `scale`: how many of the canvas's pixels are one of the list's; `fontSize`: of labels, in pixels
 * of the list.
 */
export function drawList(
  context: CanvasRenderingContext2D,
  list: readonly DrawnItem[],
  scale: number,
  fontSize: number,
): void {
  context.save();
  context.scale(scale, scale);
  context.lineJoin = 'round';
  context.font = labelFont(`${String(fontSize)}px`);
  context.direction = 'ltr';
  for (const item of list) {
    context.globalAlpha = item.opacity ?? 1;
    context.strokeStyle = HALO;
    if (item.kind !== 'label') {
      drawShape(context, item);
      continue;
    }
    const { at, text, color } = item;
    context.setLineDash([]);
    context.lineWidth = 3;
    context.strokeText(text, at.x, at.y);
    context.fillStyle = color;
    context.fillText(text, at.x, at.y);
  }
  context.restore();
}

function drawShape(context: CanvasRenderingContext2D, shape: Stroke | Disc): void {
  const path = pathOf(shape);
  const { fill, stroke } = coreOf(shape);
  context.setLineDash(shape.dashed === true ? DASHES : []);
  context.lineWidth = haloWidth(shape);
  context.stroke(path);
  if (fill !== null) {
    context.fillStyle = fill;
    context.fill(path);
  }
  if (stroke === null) return;
  context.strokeStyle = stroke;
  context.lineWidth = shape.width;
  context.stroke(path);
}

function pathOf(shape: Stroke | Disc): Path2D {
  const path = new Path2D();
  if (shape.kind === 'disc') {
    path.arc(shape.center.x, shape.center.y, shape.radius, 0, 2 * Math.PI);
    return path;
  }
  for (const line of shape.lines) {
    line.forEach(({ x, y }, i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
    if (shape.filled === true) {
      path.closePath();
    }
  }
  return path;
}
