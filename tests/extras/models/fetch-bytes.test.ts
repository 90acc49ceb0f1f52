// When does a download end? At the limit for unpacked bytes, when the load is aborted, and after a
// minute without data.
import { once } from 'node:events';
import { createServer, type Server, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { createGzip } from 'node:zlib';
import { afterAll, afterEach, beforeAll, describe, expect, it, vi } from 'vitest';
import { ModelBudget } from '../../../src/phong/model/model-budget.js';
import { byteFetcher, SILENCE_LIMIT_MS } from '../../../src/extras/models/fetch-bytes.js';
import { loadWith } from './model-files.js';

const LIMIT = 2 ** 22;
vi.mock(import('../../../src/phong/model/limits.js'), async (original) => {
  const limits = await original();
  return { ...limits, LIMITS: { ...limits.LIMITS, bytes: 2 ** 22 } as never };
});

let server: Server;
let origin = '';
let responses: ServerResponse[] = [];
let unpacked = 0;

/** Endless zeros, compressed to about a thousandth. */
async function bomb(response: ServerResponse) {
  response.writeHead(200, { 'content-encoding': 'gzip' });
  const closed = once(response, 'close');
  const gzip = createGzip();
  gzip.pipe(response);
  const zeros = Buffer.alloc(2 ** 18);
  while (!response.destroyed && unpacked < 100 * LIMIT) {
    unpacked += zeros.length;
    if (!gzip.write(zeros)) {
      await Promise.race([once(gzip, 'drain'), closed]);
    }
  }
  gzip.destroy();
}

beforeAll(async () => {
  server = createServer((request, response) => {
    responses.push(response);
    if (request.url === '/bomb') {
      void bomb(response);
    } else if (request.url === '/cut-off') {
      response.writeHead(404, { 'content-length': 1000 }).write('<p>');
      setTimeout(() => response.destroy(), 10);
    } else if (request.url === '/slow') {
      response.writeHead(200).write('glTF');
    }
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  origin = `http://127.0.0.1:${String((server.address() as AddressInfo).port)}`;
});

afterAll(() => {
  server.closeAllConnections();
  server.close();
});

afterEach(() => {
  vi.restoreAllMocks();
  vi.useRealTimers();
  responses = [];
});

const { signal: never } = new AbortController();

/** Requests `path`; gives what it ends with, and the bytes so far. */
function download(path: string, signal = never) {
  const onProgress = vi.fn((loaded: number) => loaded);
  const fetchBytes = byteFetcher({ ...loadWith(signal), onProgress }, new ModelBudget());
  const ended = fetchBytes(new URL(path, origin), 'follow').catch((error: unknown) => error);
  return { ended, loaded: () => onProgress.mock.lastCall?.[0] ?? 0 };
}

const failed = (message: unknown) => ({ code: 'load-failed', message });

const hungUp = () => expect.poll(() => responses[0]?.destroyed).toBe(true);

describe('a download', () => {
  it('that is refused has failed with its status, even where the body of the answer breaks off', async () => {
    for (let i = 0; i < 5; i += 1) {
      const { ended } = download('/cut-off');
      expect(await ended).toMatchObject(failed('The server answered 404 Not Found for cut-off.'));
    }
    const cancel = () => Promise.reject(new TypeError('network error'));
    const body = new ReadableStream({ cancel });
    vi.spyOn(globalThis, 'fetch').mockResolvedValueOnce(new Response(body, { status: 404 }));
    const { ended } = download('/gone.glb');
    expect(await ended).toMatchObject(failed('The server answered 404 for gone.glb.'));
  });

  it('of a compressed file ends at the limit, before the rest is unpacked', async () => {
    const { ended, loaded } = download('/bomb');
    expect(await ended).toMatchObject({ code: 'too-large' });
    expect(loaded()).toBeLessThanOrEqual(LIMIT);
    await hungUp();
    expect(unpacked).toBeLessThan(50 * LIMIT);
  });

  it('gives all bytes, whatever length was announced', async () => {
    for (const announced of ['', '3', '7', '9']) {
      const body = new ReadableStream<Uint8Array>({
        start: (controller) => {
          for (const piece of [
            [1, 2],
            [3, 4, 5],
            [6, 7],
          ]) {
            controller.enqueue(new Uint8Array(piece));
          }
          controller.close();
        },
      });
      const headers = announced === '' ? {} : { 'content-length': announced };
      vi.spyOn(globalThis, 'fetch').mockResolvedValueOnce(new Response(body, { headers }));
      expect(await download('/x').ended).toMatchObject({
        bytes: new Uint8Array([1, 2, 3, 4, 5, 6, 7]),
        type: '',
      });
    }
  });

  it('closes its connection when the load is aborted', async () => {
    const load = new AbortController();
    const { ended, loaded } = download('/slow', load.signal);
    await expect.poll(loaded).toBe(4);
    load.abort(new Error('enough'));
    expect(await ended).toMatchObject({ message: 'enough' });
    await hungUp();
  });

  it('waits for its turn while another file of its load gets data', async () => {
    vi.useFakeTimers();
    const [fetch, half] = [vi.spyOn(globalThis, 'fetch'), SILENCE_LIMIT_MS / 2];
    const later = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));
    let left = 5;
    const pull = (body: ReadableStreamDefaultController<Uint8Array>) =>
      later(half).then(() => (--left > 0 ? body.enqueue(new Uint8Array(1)) : body.close()));
    fetch.mockResolvedValueOnce(new Response(new ReadableStream({ pull })));
    fetch.mockReturnValueOnce(later(3 * half).then(() => new Response('late')));
    const fetchBytes = byteFetcher(loadWith(never), new ModelBudget());
    const files = ['/slow', '/late'].map((path) => fetchBytes(new URL(path, origin), 'follow'));
    await vi.advanceTimersByTimeAsync(5 * half);
    expect((await Promise.all(files)).map(({ bytes }) => bytes.length)).toEqual([4, 4]);
  });

  it.each([
    ['before its answer', '/silent', 0],
    ['in the middle', '/slow', 4],
  ])('fails if the server sends nothing for a minute %s', async (_, path, bytes) => {
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] });
    const { ended, loaded } = download(path);
    const { setImmediate: tick } = await import('node:timers/promises');
    while (responses.length === 0 || loaded() < bytes) {
      await tick();
    }
    vi.advanceTimersByTime(SILENCE_LIMIT_MS - 1);
    if (bytes > 0) {
      responses[0]?.write('more');
      while (loaded() < 2 * bytes) {
        await tick();
      }
      vi.advanceTimersByTime(SILENCE_LIMIT_MS - 1);
    }
    expect(await Promise.race([ended, tick('still waiting')])).toBe('still waiting');
    vi.advanceTimersByTime(1);
    expect(await ended).toMatchObject(failed(expect.stringMatching(/60 seconds/)));
  });
});

describe('the files of one model', () => {
  /** As many requests of one load. `open` are those that the server has not answered yet. */
  function requests(count: number, signal = never) {
    const open: (() => void)[] = [];
    let asked = 0;
    vi.spyOn(globalThis, 'fetch').mockImplementation(async () => {
      asked += 1;
      await new Promise<void>((resolve, reject) => {
        open.push(resolve);
        signal.addEventListener('abort', () => reject(new Error('aborted')));
      });
      return new Response('x');
    });
    const fetchBytes = byteFetcher(loadWith(signal), new ModelBudget());
    const results = Array.from({ length: count }, (_, i) =>
      fetchBytes(new URL(`${i}.bin`, 'https://shop.example'), 'error').then(
        () => 'loaded',
        (error: Error & { code?: string }) => error.code ?? error.message,
      ),
    );
    return { open, results, asked: () => asked };
  }

  const tick = () => new Promise<void>((resolve) => setTimeout(resolve));

  it('are requested eight at a time', async () => {
    const { open, results, asked } = requests(20);
    await tick();
    expect([asked(), open.length]).toEqual([8, 8]);
    let most = 0;
    while (asked() < 20 || open.length > 0) {
      most = Math.max(most, open.length);
      open.shift()?.();
      await tick();
    }
    expect([most, asked()]).toEqual([8, 20]);
    expect(new Set(await Promise.all(results))).toEqual(new Set(['loaded']));
  });

  it('are a thousand at most', async () => {
    const { open, results, asked } = requests(1010);
    await tick();
    // An answer is read in tasks of its own, so between two requests there may be none.
    while (asked() < 1000 || open.length > 0) {
      open.splice(0).forEach((answer) => answer());
      await tick();
    }
    const ends = await Promise.all(results);
    expect(asked()).toBe(1000);
    expect(ends.filter((end) => end === 'too-large')).toHaveLength(10);
  });

  it('that wait are not requested after the end of the load', async () => {
    const end = new AbortController();
    const { results, asked } = requests(20, end.signal);
    await tick();
    end.abort(new Error('gone'));
    expect(new Set(await Promise.all(results))).toEqual(new Set(['gone']));
    expect(asked()).toBe(8);
  });
});
