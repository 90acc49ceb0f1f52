// Requests a file of a model. Imports nothing.

export type CrossOrigin = 'anonymous' | 'use-credentials' | null;

export interface FileRequest {
  readonly response: Promise<Response>;
  /** The directive of the page's Content-Security-Policy that refused the request. Stays pending otherwise. */
  readonly refusal: Promise<string>;
  /** Stops waiting for a refusal. */
  stop(): void;
}

/** Not requested: a strict policy forbids fetching it, and what it holds is there already. */
export const isDataUri = (uri: string): boolean => /^data:/i.test(uri);

export function requestFile(
  url: URL,
  redirect: RequestRedirect,
  { signal, crossOrigin }: { readonly signal: AbortSignal; readonly crossOrigin: CrossOrigin },
): FileRequest {
  const credentials = crossOrigin === 'use-credentials' ? 'include' : 'same-origin';
  const watch = new AbortController();
  const refusal = refusalOf(url, watch.signal);
  const response = fetch(url, { signal, redirect, credentials });
  response.catch(() => undefined); // the code that awaits it reports the error
  const stop = (): void => watch.abort();
  return { response, refusal, stop };
}

/** A fetch refused by the policy rejects like a network failure. Only an event distinguishes the two. */
function refusalOf(url: URL, signal: AbortSignal): Promise<string> {
  const address = url.href.split('#', 1)[0];
  return new Promise((resolve) => {
    if (typeof document === 'undefined') return;
    const listener = (event: SecurityPolicyViolationEvent): void => {
      const mine = event.blockedURI === address || event.blockedURI === url.origin;
      if (event.disposition === 'enforce' && mine) resolve(event.effectiveDirective);
    };
    document.addEventListener('securitypolicyviolation', listener, { signal });
  });
}
