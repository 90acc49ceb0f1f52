// What has failed and is still so: told by an event, shown until it is mended. Knows nothing of how it is shown.
import type { ReactiveControllerHost } from 'lit';
import type { EventQueue } from './event-queue.js';
import { errorDetail, type ViewerErrorDetail } from './loading.js';

/** Stands for the graphics context among what can fail; models stand for themselves. */
const CONTEXT = {};

export class ViewerFailure {
  readonly #host: Pick<ReactiveControllerHost, 'requestUpdate'>;
  readonly #notices: EventQueue;
  readonly #present = new Map<object, ViewerErrorDetail>();

  constructor(host: Pick<ReactiveControllerHost, 'requestUpdate'>, notices: EventQueue) {
    this.#host = host;
    this.#notices = notices;
  }

  /** For the page's reader: the newest of what has failed; null where nothing has. */
  get message(): string | null {
    return [...this.#present.values()].at(-1)?.message ?? null;
  }

  /** `subject` has failed. */
  tell(subject: object, detail: ViewerErrorDetail): void {
    this.#present.delete(subject);
    this.#present.set(subject, detail);
    this.#host.requestUpdate();
    this.#notices.tell('error', detail, detail);
  }

  /** `subject` works, or is no more. */
  mended(subject: object): void {
    if (this.#present.delete(subject)) this.#host.requestUpdate();
  }

  contextMissing(error: Error): void {
    this.tell(CONTEXT, errorDetail(error, null));
  }

  contextLost(): void {
    const message = 'The graphics context was lost. The picture comes back when the browser gives it back.';
    this.tell(CONTEXT, { code: 'context-lost', message, url: null });
  }

  contextRestored(): void {
    this.mended(CONTEXT);
  }
}
