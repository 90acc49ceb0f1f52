// Draws a display list into a picture file by Canvas 2D: an SVG image would need a `blob:` or `data:` address, which a
// strict CSP refuses. The same looks as svg-layer.ts.
import { HALO } from './contrast.js';
import { DASHES, type Disc, labelFont, outlineOf, type DrawnItem, type Stroke } from './display-list.js';

/**
 * How a picture file shows a layer of this height: as large in proportion as on the page. `width` and `height` are the
 * picture's in the layer's pixels, `scale` how many of the picture's pixels are one of them.
 */
export function fileSize(
  picture: HTMLCanvasElement,
  layerHeight: number,
): { readonly width: number; readonly height: number; readonly scale: number } {
  const scale = layerHeight > 0 ? picture.height / layerHeight : 1;
  return { width: picture.width / scale, height: picture.height / scale, scale };
}

/**
 * Draws the list; `scale` is how many of the canvas's pixels are one of the list's, `fontSize` that of labels in pixels
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
  for (const primitive of list) {
    context.globalAlpha = primitive.opacity ?? 1;
    if (primitive.kind === 'label') drawLabel(context, primitive);
    else drawShape(context, primitive);
  }
  context.restore();
}

function drawLabel(
  context: CanvasRenderingContext2D,
  { at, text, color }: Extract<DrawnItem, { kind: 'label' }>,
): void {
  context.direction = 'ltr';
  context.setLineDash([]);
  context.strokeStyle = HALO;
  context.lineWidth = 3;
  context.strokeText(text, at.x, at.y);
  context.fillStyle = color;
  context.fillText(text, at.x, at.y);
}

function drawShape(context: CanvasRenderingContext2D, shape: Stroke | Disc): void {
  const path = pathOf(shape);
  const { color, width } = shape;
  context.setLineDash(shape.dashed === true ? [...DASHES] : []);
  context.strokeStyle = HALO;
  context.lineWidth = width + 2 * outlineOf(shape);
  context.stroke(path);
  const isFilled = shape.kind === 'stroke' && shape.filled === true;
  const fill = shape.kind === 'disc' ? shape.fill : isFilled ? color : null;
  if (fill !== null) {
    context.fillStyle = fill;
    context.fill(path);
  }
  if (isFilled) return;
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke(path);
}

function pathOf(shape: Stroke | Disc): Path2D {
  const path = new Path2D();
  if (shape.kind === 'disc') {
    path.arc(shape.center.x, shape.center.y, shape.radius, 0, 2 * Math.PI);
    return path;
  }
  for (const line of shape.lines) {
    line.forEach(({ x, y }, i) => {
      if (i === 0) path.moveTo(x, y);
      else path.lineTo(x, y);
    });
    if (shape.filled === true) path.closePath();
  }
  return path;
}
