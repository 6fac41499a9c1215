import { describe, expect, it } from 'vitest';
import { WAYS } from '../../test/ways.ts';
import { httpPoller } from './http-poller.ts';

/** A web that is answered by the test. */
class FakeWeb {
  readonly urls: string[] = [];
  #answers: {
    resolve(answer: { status: number; text: string }): void;
    reject(error: unknown): void;
  }[] = [];
  readonly modules = {
    http: {
      get: (url: string): Promise<{ status: number; text: string }> => {
        this.urls.push(url);
        return new Promise((resolve, reject) => this.#answers.push({ resolve, reject }));
      },
    },
  };

  /** Answers the oldest open request. */
  async answer(text: unknown, status = 200): Promise<void> {
    const body = typeof text === 'string' ? text : JSON.stringify(text);
    this.#answers.shift()!.resolve({ status, text: body });
    await this.#delivered();
  }

  async fail(error: unknown): Promise<void> {
    this.#answers.shift()!.reject(error);
    await this.#delivered();
  }

  /** Callbacks of promises run in order, so those of the answer have run before this one. */
  async #delivered(): Promise<void> {
    await Promise.resolve();
  }
}

const URL = 'http://sensor.local/state';

describe.each(WAYS)('http-poller %s', (_way, drive) => {
  async function start(inputs: { [name: string]: unknown } = {}) {
    const web = new FakeWeb();
    const module = await drive(httpPoller, web.modules);
    await module.run(0, { url: URL, ...inputs });
    return { web, module };
  }

  it('cannot start on a node without the library [PM-4] [PM-13]', async () => {
    await expect(drive(httpPoller)).rejects.toMatchObject({
      message: expect.stringMatching(/does not (have|offer) the library "?http/),
    });
  });

  it('asks at once and puts the number at the path out', async () => {
    const { web, module } = await start({ path: 'sensors[1].value' });
    expect(web.urls).toEqual([URL]);
    expect(await module.run(100)).toEqual({});
    await web.answer({ sensors: [{ value: 1 }, { value: 21.5 }] });
    expect(await module.run(100)).toEqual({ number: 21.5, text: '21.5', status: 200 });
    expect(await module.run(100)).toEqual({});
  });

  it.each([
    ['', 7, { number: 7, text: '7' }],
    ['$', 7, { number: 7, text: '7' }],
    ['$.a', { a: 0 }, { number: 0, text: '0' }],
    ['a.0.b', { a: [{ b: '12' }] }, { number: 12, text: '12' }],
    ['a', { a: true }, { number: 1, text: 'true' }],
    ['a', { a: 'open' }, { text: 'open' }],
    ['a', { a: '' }, { text: '' }],
    ['a', { a: null }, { text: 'null' }],
    ['a', { a: { b: 1 } }, { text: '{"b":1}' }],
    ['', '  plain words \n', { text: 'plain words' }],
  ])('finds "%s" in %j', async (path, body, outputs) => {
    const { web, module } = await start({ path });
    await web.answer(body);
    expect(await module.run(100)).toEqual({ ...outputs, status: 200 });
  });

  it.each([
    ['a.b', { a: { c: 1 } }, 'The response has no "a.b": "b" is missing.'],
    ['a.b', { a: null }, 'The response has no "a.b": "b" is missing.'],
    ['a.constructor', { a: {} }, 'The response has no "a.constructor": "constructor" is missing.'],
    ['a', 'plain words', 'The response is not JSON, so it has no "a".'],
  ])('says what is wrong with "%s" in %j', async (path, body, error) => {
    const { web, module } = await start({ path });
    await web.answer(body);
    expect(await module.run(100)).toEqual({ status: 200, error });
  });

  it('says once that a service fails, and once that it is well again', async () => {
    const { web, module } = await start({ intervalMs: 100 });
    await web.answer('no', 503);
    const error = 'The service responded with status 503.';
    expect(await module.run(100)).toEqual({ status: 503, error });
    await web.answer('no', 503);
    expect(await module.run(100)).toEqual({ status: 503 });
    await web.answer('1');
    expect(await module.run(100)).toEqual({ status: 200, number: 1, text: '1', error: '' });
    await web.fail(new Error('connection refused'));
    expect(await module.run(100)).toEqual({ error: 'The request failed: connection refused' });
  });

  it('keeps to its interval, and has one request under way', async () => {
    const { web, module } = await start({ intervalMs: 250 });
    await module.run(300);
    expect(web.urls).toHaveLength(1);
    await web.answer('1');
    await module.run(0);
    expect(web.urls).toHaveLength(2);
    await web.answer('2');
    expect(await module.run(100)).toMatchObject({ number: 2 });
    expect(web.urls).toHaveLength(2);
    await module.run(100);
    expect(web.urls).toHaveLength(3);
  });

  it('does not catch up on what it missed in a gap', async () => {
    const { web, module } = await start({ intervalMs: 100 });
    await web.answer('1');
    await module.run(60_000);
    await web.answer('2');
    await module.run(10);
    expect(web.urls).toHaveLength(2);
  });

  it('gives up on an answer that takes too long, and does not take it for the next one', async () => {
    const { web, module } = await start({ timeoutMs: 500, path: '' });
    expect(await module.run(500)).toEqual({ error: 'The service did not respond within 500 ms.' });
    await module.run(500);
    expect(web.urls).toHaveLength(2);
    await web.answer('1');
    expect(await module.run(10)).toEqual({});
    await web.answer('2');
    expect(await module.run(10)).toMatchObject({ number: 2, error: '' });
  });

  it('requests a new URL at once, and drops the response of the old one', async () => {
    const { web, module } = await start({ intervalMs: 60_000 });
    await module.run(100, { url: 'https://other.local/' });
    expect(web.urls).toEqual([URL, 'https://other.local/']);
    await web.answer('1');
    expect(await module.run(100)).toEqual({});
    await web.answer('2');
    expect(await module.run(100)).toMatchObject({ number: 2 });
  });

  it('waits for an address, and refuses what is none', async () => {
    const { web, module } = await start({ url: undefined });
    expect(await module.run(100)).toEqual({});
    expect(await module.run(100, { url: 'ftp://sensor' })).toEqual({
      error: '"ftp://sensor" is not a web address. It must start with http:// or https://.',
    });
    expect(await module.run(2000)).toEqual({});
    expect(web.urls).toEqual([]);
  });

  it('clamps its interval, and uses defaults for parameters that are not finite', async () => {
    const { web, module } = await start({ intervalMs: -1, timeoutMs: NaN });
    await web.answer('1');
    await module.run(99);
    expect(web.urls).toHaveLength(1);
    await module.run(1);
    expect(web.urls).toHaveLength(2);
    expect(await module.run(9_999)).toEqual({});
    expect(await module.run(1)).toEqual({ error: 'The service did not respond within 10000 ms.' });
  });
});
