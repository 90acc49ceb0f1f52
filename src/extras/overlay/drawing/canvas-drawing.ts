// Draws a display list into a picture file by Canvas 2D: an SVG image would need a `blob:` or
// `data:` address, which a strict CSP refuses. The same looks as svg-layer.ts.
import type { ExtraHost } from '../../../viewer/extra.js';
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
import { Projection } from './projection.js';

/**
 * The layer of a picture file, as large in it, in proportion, as on the page: the view onto it, all
 * of it, and what draws a list there with labels of this size.
 */
export function fileLayer(host: ExtraHost, picture: HTMLCanvasElement) {
  const { height: pageHeight } = host.size();
  /** How many of the picture's pixels are one of the layer's. */
  const scale = pageHeight > 0 ? picture.height / pageHeight : 1;
  const [width, height] = [picture.width / scale, picture.height / scale];
  const { orbit, fit } = host.viewport.picture;
  return {
    view: new Projection({ pose: orbit.pose, fov: fit.fov, width, height }),
    room: { left: 0, top: 0, right: width, bottom: height },
    draw: (list: readonly DrawnItem[], fontSize: number): void => {
      const context = picture.getContext('2d');
      if (context !== null) {
        drawList(context, list, scale, fontSize);
      }
    },
  };
}

function drawList(
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
