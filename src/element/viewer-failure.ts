// What has failed and is still so: told by an event, shown until it is mended. Knows nothing of how it is shown.
import type { ReactiveControllerHost } from 'lit';
import { NoWebGL2Error } from '../scene/stage.js';
import type { Notices } from './notices.js';
import { errorDetail, type ViewerErrorCode, type ViewerErrorDetail } from './viewer-loading.js';

const OF_LOADING: readonly ViewerErrorCode[] = ['load-failed', 'bad-model', 'too-large', 'csp'];

export class ViewerFailure {
  readonly #host: Pick<ReactiveControllerHost, 'requestUpdate'>;
  readonly #notices: Notices;
  #present: ViewerErrorDetail | null = null;

  constructor(host: Pick<ReactiveControllerHost, 'requestUpdate'>, notices: Notices) {
    this.#host = host;
    this.#notices = notices;
  }

  /** For the page's reader; null where nothing has failed. */
  get message(): string | null {
    return this.#present?.message ?? null;
  }

  tell(detail: ViewerErrorDetail): void {
    this.#show(detail);
    this.#notices.tell('error', detail);
  }

  /** Does `start`; false where there is no WebGL 2, which is told. */
  needsWebGL2(start: () => void): boolean {
    try {
      start();
      return true;
    } catch (error) {
      if (!(error instanceof NoWebGL2Error)) throw error;
      this.tell(errorDetail(error, null));
      return false;
    }
  }

  contextLost(): void {
    const message = 'The graphics context was lost. The picture comes back when the browser gives it back.';
    this.tell({ code: 'context-lost', message, url: null });
  }

  contextRestored(): void {
    if (this.#present?.code === 'context-lost') this.#show(null);
  }

  /** Something else is being loaded. */
  loadingAgain(): void {
    if (this.#present !== null && OF_LOADING.includes(this.#present.code)) this.#show(null);
  }

  #show(detail: ViewerErrorDetail | null): void {
    this.#present = detail;
    this.#host.requestUpdate();
  }
}
