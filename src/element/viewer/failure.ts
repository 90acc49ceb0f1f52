// What has failed and still does: reported once by an event, shown as a message until it works again. Knows nothing of
// how the message is shown.
import type { ReactiveControllerHost } from '@lit/reactive-element';
import type { EventQueue } from './event-queue.js';
import { errorDetail, type ViewerErrorDetail } from './loading.js';

/** The subject of failures of the graphics context; a model's subject is its mesh. */
const CONTEXT = {};

export class ViewerFailure {
  readonly #host: Pick<ReactiveControllerHost, 'requestUpdate'>;
  readonly #events: EventQueue;
  readonly #present = new Map<object, ViewerErrorDetail>();

  constructor(host: Pick<ReactiveControllerHost, 'requestUpdate'>, events: EventQueue) {
    this.#host = host;
    this.#events = events;
  }

  /** The newest failure that is not cleared; null for none. */
  get newest(): ViewerErrorDetail | null {
    return [...this.#present.values()].at(-1) ?? null;
  }

  /** Something has failed that a retry may fix. A lost context needs no retry. */
  get retryable(): boolean {
    return [...this.#present.values()].some(({ code }) => code !== 'context-lost');
  }

  report(subject: object, detail: ViewerErrorDetail): void {
    this.#present.delete(subject);
    this.#present.set(subject, detail);
    this.#host.requestUpdate();
    this.#events.append('error', detail);
  }

  /** `subject` works, or is gone. */
  cleared(subject: object): void {
    if (this.#present.delete(subject)) this.#host.requestUpdate();
  }

  contextMissing(error: Error): void {
    this.#reportContext(errorDetail(error, null));
  }

  contextLost(): void {
    const message =
      'The graphics context was lost. The picture returns when the browser restores the context.';
    this.#reportContext({ code: 'context-lost', message, url: null });
  }

  contextRestored(): void {
    this.cleared(CONTEXT);
  }

  /** Once, however often the context is lost again or refused before it works. */
  #reportContext(detail: ViewerErrorDetail): void {
    if (this.#present.get(CONTEXT)?.code !== detail.code) this.report(CONTEXT, detail);
  }
}
