// What has failed and still does: reported once by an event, shown as a message until it works again.
import type { ViewerErrorDetail } from '../events.js';
import type { Failure, FailureSubject, ViewerContext } from './viewer-context.js';
import type { EventQueue } from './event-queue.js';
import { errorDetail } from './loading.js';

/** The subject of failures of the graphics context; a model's subject is its mesh. */
const CONTEXT: FailureSubject = {};

const LOST: ViewerErrorDetail = {
  code: 'context-lost',
  message: 'The graphics context was lost. The picture returns when the browser restores the context.',
  url: null,
};

export class ViewerFailure {
  readonly #viewer: ViewerContext['viewer'];
  readonly #events: EventQueue;
  readonly #present = new Map<FailureSubject, Failure>();

  constructor({ viewer, signals }: ViewerContext, events: EventQueue) {
    this.#viewer = viewer;
    this.#events = events;
    signals.failed.listen((failure) => this.#report(failure));
    signals.cleared.listen((subject) => this.#clear(subject));
    signals.contextMissing.listen((error) => this.#reportContext(errorDetail(error, null)));
    signals.contextLost.listen(() => this.#reportContext(LOST));
    signals.contextRestored.listen(() => this.#clear(CONTEXT));
  }

  /** The newest failure that is not cleared; null for none. */
  get newest(): Failure | null {
    return [...this.#present.values()].at(-1) ?? null;
  }

  /**
   * Something has failed that a retry may fix. A lost context needs no retry, and a file of the user's own is not
   * requested.
   */
  get retryable(): boolean {
    return [...this.#present].some(
      ([{ isOwnFile }, { detail }]) => isOwnFile !== true && detail.code !== 'context-lost',
    );
  }

  /** The newest failure is of a file of the user's own, so the user may remove its message. */
  get dismissible(): boolean {
    return this.#subject?.isOwnFile === true;
  }

  /** Removes the message of {@link newest}. False unless it is {@link dismissible}. */
  readonly dismiss = (): boolean => {
    const { dismissible } = this;
    if (dismissible) this.#clear(this.#subject!);
    return dismissible;
  };

  get #subject(): FailureSubject | undefined {
    return [...this.#present.keys()].at(-1);
  }

  #report(failure: Failure): void {
    const { subject, detail } = failure;
    this.#present.delete(subject);
    this.#present.set(subject, failure);
    this.#viewer.requestUpdate();
    this.#events.append('error', detail);
  }

  /** `subject` works, or is gone. */
  #clear(subject: FailureSubject): void {
    if (this.#present.delete(subject)) this.#viewer.requestUpdate();
  }

  /** Once, however often the context is lost again or refused before it works. */
  #reportContext(detail: ViewerErrorDetail): void {
    const known = this.#present.get(CONTEXT)?.detail.code;
    if (known !== detail.code) this.#report({ subject: CONTEXT, detail, fact: detail.message });
  }
}
