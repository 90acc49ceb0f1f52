// What has failed and still does: reported once by an event, shown as a message until it works
// again.
import { clipMessage } from '../../../phong/fields/clip.js';
import { isOutOfMemory } from '../../../phong/model/limits.js';
import { ModelError } from '../../../phong/model/model.js';
import { nameOf } from '../../../phong/fields/file-names.js';
import { NoWebGL2Error } from '../../../phong/material/device.js';
import type { SceneMesh } from '../../scene/mesh/scene-mesh.js';
import type { ViewerErrorDetail } from '../elements.js';
import type { ViewerErrorCode } from '../fields/texts.js';
import type { EventQueue } from './event-queue.js';
import type { ViewerContext } from './viewer-context.js';

/** What can fail and work again: a mesh, or the graphics context. */
interface FailureSubject {
  readonly isOwnFile?: boolean;
}

export interface Failure {
  readonly subject: FailureSubject;
  readonly detail: ViewerErrorDetail;
  /**
   * What visitors read: the file and what is wrong, without advice that only the author can follow.
   */
  readonly fact: string;
}

const CONTEXT: FailureSubject = {};

const LOST: ViewerErrorDetail = {
  code: 'context-lost',
  message:
    'The graphics context was lost. The picture returns when the browser restores the context.',
  url: null,
};

export class ViewerFailure {
  readonly #viewer: ViewerContext['viewer'];
  readonly #events: EventQueue;
  readonly #present = new Map<FailureSubject, Failure>();
  /** Advice that the console has. */
  readonly #given = new Set<string>();

  constructor({ viewer, signals }: ViewerContext, events: EventQueue) {
    this.#viewer = viewer;
    this.#events = events;
    signals.contextMissing.listen((error) => this.#reportContext(detailOf(error, null)));
    signals.contextLost.listen(() => this.#reportContext(LOST));
    signals.contextRestored.listen(() => this.clear(CONTEXT));
  }

  get newest(): Failure | null {
    return [...this.#present.values()].at(-1) ?? null;
  }

  /** Something has failed that a retry may fix: no lost context, and no file of the user's own. */
  get retryable(): boolean {
    return [...this.#present.values()].some(
      ({ subject, detail }) => subject.isOwnFile !== true && detail.code !== 'context-lost',
    );
  }

  /** The newest failure is of a file of the user's own, so the user may remove its message. */
  get dismissible(): boolean {
    return this.newest?.subject.isOwnFile === true;
  }

  /** A mesh cannot be shown; `url` is that of its file. Returns the detail of its event. */
  report(mesh: SceneMesh, error: unknown, url: URL | null): ViewerErrorDetail {
    const detail = detailOf(error, url);
    this.#add({ subject: mesh, detail, fact: this.#factOf(error, detail, mesh.isOwnFile, url) });
    return detail;
  }

  /** `subject` works, or is gone. */
  clear(subject: FailureSubject): void {
    if (this.#present.delete(subject)) {
      this.#viewer.requestUpdate();
    }
  }

  /** Once, however often the context is lost again or refused before it works. */
  #reportContext(detail: ViewerErrorDetail) {
    const code = this.#present.get(CONTEXT)?.detail.code;
    if (code !== detail.code) {
      this.#add({ subject: CONTEXT, detail, fact: detail.message });
    }
  }

  #add(failure: Failure) {
    const { subject, detail } = failure;
    this.#present.delete(subject);
    this.#present.set(subject, failure);
    this.#viewer.requestUpdate();
    this.#events.append('error', detail);
  }

  /**
   * With what they can do about their own file. The console has what only the author can do, the
   * same advice once.
   */
  #factOf(error: unknown, { message }: ViewerErrorDetail, isOwn: boolean, url: URL | null): string {
    const shown = !(error instanceof ModelError)
      ? message
      : clipMessage(isOwn ? error.ownMessage : error.fact);
    if (error instanceof ModelError && shown !== message && !error.logged) {
      const advice = error.message.slice(error.fact.length);
      // Each file is named once. Shapes have no address: for them the advice alone counts.
      const key = `${url?.href ?? ''}${advice}`;
      if (!this.#given.has(key)) {
        console.warn(message);
      }
      this.#given.add(key);
    }
    const name = url === null ? '' : nameOf(url);
    // Its end may have been clipped.
    return shown.includes(name.slice(0, 60))
      ? shown
      : `${shown.replace(/\.$/, '')} (${clipMessage(name)}).`;
  }
}

function detailOf(error: unknown, url: URL | null): ViewerErrorDetail {
  const code = codeOf(error);
  let message = error instanceof Error ? error.message : String(error);
  if (code === 'too-large' && !(error instanceof ModelError)) {
    message = 'There is not enough memory to show this.';
  }
  return { code, message: clipMessage(message), url: url?.href ?? null };
}

function codeOf(error: unknown): ViewerErrorCode {
  if (error instanceof ModelError) return error.code;
  if (isOutOfMemory(error)) return 'too-large';
  return error instanceof NoWebGL2Error ? 'no-webgl2' : 'load-failed';
}
