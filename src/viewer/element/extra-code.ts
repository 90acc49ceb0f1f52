// The code of extras that the elements use, as far as they use it. The table of extras says how it
// is fetched (`viewer/extras.ts`).
import type { ReactiveController, TemplateResult } from 'lit';
import { type ExtraCode, extraCode } from '../model/provided-code.js';
import type {
  ElementTypes,
  FragmentExplanation,
  PhongCompare,
  PhongViewer,
  PictureOptions,
  ShadeOptions,
} from './elements.js';
import type { ElementCode } from './fetched-element.js';
import type { ExtraRows } from './panel-rows.js';
import type { ViewerSnapshot } from './viewer/extra-host.js';

/** What has changed, so that a panel updates only that. */
export type PanelChange = 'camera' | 'lights' | 'meshes' | 'viewer';

/** What the element needs of a control panel. */
export interface Panel {
  /** Called after changes, once per kind and task. Requests no frames. */
  readonly update: (change: PanelChange) => void;
  dispose(): void;
}

export const panelCode = /* @__PURE__ */ extraCode<{
  /** Builds the panel inside `place`; its styles go to `root`, the viewer's shadow root. */
  readonly createPanel: (viewer: PhongViewer, place: HTMLElement, root: ShadowRoot) => Panel;
  readonly takeRows: (rows: ExtraRows) => void;
}>('the control panel');

export const controlCode = /* @__PURE__ */ extraCode<
  ElementCode & { readonly takeRows: (rows: ExtraRows) => void }
>('<phong-control>');

const elementCodes: Partial<Record<keyof ElementTypes, ExtraCode<ElementCode>>> = {};

export const elementCode = (tag: keyof ElementTypes): ExtraCode<ElementCode> =>
  (elementCodes[tag] ??= extraCode(`<${tag}>`));

/** Lays out the viewers of a comparison. */
export interface Comparison extends ReactiveController {
  template(): TemplateResult;
}

export const comparisonCode = /* @__PURE__ */ extraCode<{
  readonly Comparison: new (element: PhongCompare) => Comparison;
}>('<phong-compare>');

/** As the methods of `<phong-viewer>`, of what was copied at the call. */
interface ExplanationCode {
  shadeAt(
    snapshot: ViewerSnapshot,
    x: number,
    y: number,
    options?: ShadeOptions,
  ): Promise<FragmentExplanation | null>;
  explain(snapshot: ViewerSnapshot, point: unknown): Promise<FragmentExplanation | null>;
}

export const explanationCode = /* @__PURE__ */ extraCode<ExplanationCode>('shadeAt');

/** Encodes a picture. */
interface PictureCode {
  readonly pictureBlob: (
    picture: HTMLCanvasElement,
    options: PictureOptions,
    markup: string,
  ) => Promise<Blob>;
}

export const pictureCode = /* @__PURE__ */ extraCode<PictureCode>('toBlob');

/** What is known of an element, for the code that explains mistakes. */
export interface MistakeTests {
  strayAttributes(element: Element): string[];
  dimValues(element: Element): readonly string[];
  wrappedViewer(compare: Element): Element | null;
  isFlat(element: Element): boolean;
  isCollapsed(element: Element): boolean;
  isNamed(element: PhongViewer): boolean;
  registryAround(element: Element): object | null;
}

export const diagnosisCode = /* @__PURE__ */ extraCode<{
  readonly diagnose: (suspects: readonly Element[], tests: MistakeTests) => void;
}>('the diagnosis');
