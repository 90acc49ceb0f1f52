// The models that meshes show now. Equal sources are one download and one content for the whole
// page; users are counted. A model that moves gets matrices and moving vertices of its own for each
// mesh.
import { type Amounts, type Budget, type Claim, NO_CLAIMS } from '../../../phong/model/budget.js';
import type { Content } from '../../../phong/model/model.js';
import {
  type CrossOrigin,
  modelCode,
  requestFile,
  requestModelFile,
} from '../../model/request-model.js';
import { isDataUri } from '../../../phong/fields/file-names.js';
import { Shared } from '../../model/shared.js';
import { stage } from '../gpu/stage.js';

interface ModelName {
  /** A file's address is not fetched: it is for messages. */
  readonly url: URL;
  readonly src: string | Blob;
  readonly type: string;
  readonly crossOrigin: CrossOrigin;
}

/** A mesh that shows a model, or is going to. */
interface ModelUser {
  readonly claim: Claim;
  /** Aborted when the mesh no longer wants the model. */
  readonly signal: AbortSignal;
  readonly onProgress: (loaded: number, total: number) => void;
}

const models = new Shared<SharedModel>();

/**
 * For one more mesh, which disposes of it once. Rejects if it is unreadable or too large for the
 * claim.
 */
export function acquireModel(name: ModelName, user: ModelUser): Promise<Content> {
  return models.acquire(keyOf(name), () => new SharedModel(name)).use(user);
}

const files = new WeakMap<Blob, number>();
let fileCount = 0;

function keyOf({ url, src, type, crossOrigin }: ModelName): string {
  if (typeof src === 'string') return `${url.href} ${type} ${String(crossOrigin)}`;
  const number = files.get(src) ?? ++fileCount;
  files.set(src, number);
  return `${String(number)} ${type} ${String(crossOrigin)}`;
}

/** A function of the module: textures keep it, and one of the model would keep the model. */
const flush = () => stage.flush();

class SharedModel {
  readonly #loading = new AbortController();
  readonly #content: Promise<Content>;
  /** Users to whom it has not come yet, each with what refuses it. */
  readonly #waiting = new Map<ModelUser, (error: unknown) => void>();
  #claimed: Amounts = NO_CLAIMS;

  constructor({ url, src, type, crossOrigin }: ModelName) {
    const onProgress = (loaded: number, total: number): void => {
      for (const user of this.#waiting.keys()) {
        user.onProgress(loaded, total);
      }
    };
    const { signal } = this.#loading;
    const options = { signal, crossOrigin };
    const load = {
      signal,
      onProgress,
      onClaim: this.#claim,
      request: (file: URL, redirect: RequestRedirect) => requestFile(file, redirect, options),
      anywhere: crossOrigin !== null,
      type,
      flush,
    };
    // Requested at once, beside the code that reads models.
    const request =
      typeof src !== 'string' ? src : isDataUri(url.href) ? null : requestModelFile(url, options);
    this.#content = modelCode().then(async ({ modelContent, ownedModel }) => {
      const content = await modelContent(url, load, request);
      models.hold(this, ownedModel(content.parts)); // the content itself refers to this one
      return content;
    });
    this.#content.catch(() => {
      models.forget(this); // the next request tries again
    });
  }

  /** For a user who has acquired it. */
  async use(user: ModelUser): Promise<Content> {
    const { claim, signal } = user;
    try {
      const refused = new Promise<never>((_, reject) => {
        this.#waiting.set(user, reject);
        signal.addEventListener('abort', () => reject(signal.reason as Error));
      });
      const content = await Promise.race([this.#content, refused]);
      claim.add([{ key: this, claims: this.#claimed, flat: false }]);
      const own = content.motion === null ? content : await this.#moving(content, claim);
      let used = true;
      return {
        ...own,
        dispose: () => {
          if (!used) return;
          used = false;
          if (own !== content) {
            own.dispose();
          }
          this.#release();
        },
      };
    } catch (error) {
      this.#release();
      throw error;
    } finally {
      this.#waiting.delete(user);
    }
  }

  async #moving(content: Content, claim: Claim): Promise<Content> {
    const { movingCopy, movingValues } = await modelCode();
    claim.add([{ key: claim, claims: { values: movingValues(content) }, flat: false }]);
    return movingCopy(content);
  }

  /** The meshes of a viewer share the content: the first one that waits claims for all. */
  readonly #claim = (claimed: Amounts): void => {
    this.#claimed = claimed;
    const asked = new Set<Budget>();
    let refusal: Error | null = null;
    for (const [{ claim }, refuse] of this.#waiting) {
      if (asked.has(claim.budget)) continue;
      try {
        claim.add([{ key: this, claims: claimed, flat: false }]);
        asked.add(claim.budget);
      } catch (error) {
        refusal = error as Error;
        refuse(error);
      }
    }
    if (asked.size === 0 && refusal !== null) throw refusal;
  };

  #release(): void {
    if (!models.release(this)) return;
    models.forget(this);
    this.#loading.abort('unused'); // ends what is still being downloaded
    this.#content.then(
      (content) => content.dispose(),
      () => undefined,
    );
  }
}
