// What an error budget gives up and gains: the element itself, once for each budget, under lamps that fall off.
import type { FieldPage } from '../pages/field.js';
import { pictureOf } from './core-view.js';
import { type Field, fieldOf, fieldReference, insides } from './field.js';
import { openFrame } from './framed.js';
import { type Axis, type Size, type Stand, type Subject } from './stand.js';

const BUDGETS = [0, 0.25, 0.5, 1, 2, 4] as const;
const QUICK_BUDGETS = [0, 1, 4] as const;
const SCENES: Readonly<Record<string, { lamps: number; floor: boolean }>> = {
  '8 lamps': { lamps: 8, floor: false },
  '32 lamps': { lamps: 32, floor: false },
  '128 lamps': { lamps: 128, floor: false },
  '1000 lamps': { lamps: 1000, floor: false },
  '200 lamps on a floor': { lamps: 200, floor: true },
};
/** Of a picture's pixels, how many lie inside faces, at most: for how large a reference may be. */
const COVERED = 0.5;

export const budget: Axis = {
  title: 'The error budget',
  scenes: Object.keys(SCENES),
  async open(name, { size, seed, evaluations, quick = false }, holder) {
    const { lamps, floor } = SCENES[name]!;
    const field = fieldOf(lamps, floor, seed);
    const shrink = Math.min(1, Math.sqrt(evaluations / (COVERED * lamps * size[0] * size[1])));
    const errorSize: Size = [least(size[0] * shrink), least(size[1] * shrink)];
    const subjects: Subject[] = [];
    for (const errorBudget of quick ? QUICK_BUDGETS : BUDGETS) {
      const query = { lamps, floor: floor ? 1 : 0, seed, budget: errorBudget };
      const page = await openFrame<FieldPage>(holder, 'field.html', query, size, 'field');
      subjects.push(subjectOf(page, errorBudget, size, errorSize, field));
    }
    const stand: Stand = {
      title: `The error budget: ${name.replace('1000', '1,000')}${floor ? '' : ' over 30 boxes'}`,
      truth: 'the equation in float64, inside faces',
      ...{ base: '0', shipped: '0', size, errorSize, subjects },
      reference: (pace) => fieldReference(field, errorSize, pace),
      close: () => {
        holder.replaceChildren();
      },
    };
    return stand;
  },
};

/** Whole pixels, and enough of them to have faces. */
const least = (side: number): number => Math.max(Math.round(side), 48);

function subjectOf(page: FieldPage, errorBudget: number, size: Size, errorSize: Size, field: Field): Subject {
  return {
    id: String(errorBudget),
    label: `error-budget="${String(errorBudget)}"`,
    gl: page.gl,
    draw: () => {
      page.draw();
    },
    async picture() {
      await page.resize(...errorSize);
      page.draw();
      const [width, height] = errorSize;
      const codes = new Uint8Array(width * height * 4);
      page.gl.readPixels(0, 0, width, height, page.gl.RGBA, page.gl.UNSIGNED_BYTE, codes);
      await page.resize(...size);
      const picture = pictureOf(codes, errorSize);
      insides(field, errorSize).forEach((own, k) => {
        if (own === null) picture.data.fill(0, 3 * k, 3 * k + 3);
      });
      return picture;
    },
  };
}
