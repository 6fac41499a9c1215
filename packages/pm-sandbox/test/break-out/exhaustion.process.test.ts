import { describe, expect, it } from 'vitest';
import { faultFrom, recordInput, valuesOf } from '../../src/testing/index.ts';
import { untrustedSandboxes } from './fixture.ts';

/** Each never ends. */
const ENDLESS = {
  'a loop': '() => { for (;;) {} }',
  'a loop that catches everything':
    '() => { for (;;) { try { for (;;) {} } catch {} finally { continue } } }',
  'promise jobs': 'async () => { for (;;) await null }',
  'promise jobs left behind': '() => { (async () => { for (;;) await null })() }',
  'a thenable': '() => ({ then(resolve) { Promise.resolve().then(() => { for (;;) {} }) } })',
  'a thenable of itself': '() => { const self = { then(resolve) { resolve(self) } }; return self }',
  toJSON: '() => ({ outputs: { out: { toJSON() { for (;;) {} } } } })',
  'a getter': '() => ({ outputs: { get out() { for (;;) {} } } })',
  'a message of an error': '() => { throw { get message() { for (;;) {} } } }',
  'toString of what is thrown': '() => { throw { toString() { for (;;) {} } } }',
  'a regular expression': '() => /^(a|a)+$/.test("a".repeat(60) + "b")',
  'an iterator':
    '() => [...{ *[Symbol.iterator]() { for (;;) yield 0 } }].length && 0 || (() => { for (;;) {} })()',
  'a generator of promises':
    'async () => { for await (const _ of (async function* () { for (;;) yield 1 })()) {} }',
  'a console': '() => { for (;;) console.log("x".repeat(5000)) }',
  'a sort': '() => [1, 2].sort(() => { for (;;) {} })',
  'a Proxy': '() => ({ outputs: new Proxy({}, { get() { for (;;) {} } }) })',
};

/** Each wants more than there is. */
const GREEDY = {
  arrays: '() => { const all = []; for (;;) all.push(new Array(10000).fill(0)) }',
  'one text': '() => { let text = "x"; for (;;) text += text }',
  'one buffer': '() => new ArrayBuffer(2 ** 30)',
  buffers: '() => { const all = []; for (;;) all.push(new ArrayBuffer(1e6)) }',
  'shared buffers':
    '() => { const all = []; for (;;) all.push(typeof SharedArrayBuffer === "undefined" ? new Uint8Array(1e6) : new SharedArrayBuffer(1e6)) }',
  promises: '() => { const all = []; for (;;) all.push(new Promise(() => {})) }',
  maps: '() => { const map = new Map(); for (let i = 0; ; i++) map.set(i, { i }) }',
  'big integers': '() => { let n = 2n; for (;;) n *= n }',
  'a result': '() => ({ outputs: { out: { string: "x".repeat(3e7) } } })',
};

describe('what uses up time or memory ends its own instance [PM-53]', () => {
  const { create, attempt } = untrustedSandboxes();
  const isAlive = async (): Promise<void> => expect(await attempt('return 1 + 1')).toBe('2');

  it.each(Object.entries(ENDLESS))('endless: %s', async (_, onProcessing) => {
    const { run, killed } = await create({ onProcessing, limits: { callTimeoutMs: 150 } });
    const fault = await faultFrom(run());
    expect(['timeout', 'memory']).toContain(fault.kind);
    expect(await killed).toEqual(fault);
    await isAlive();
  });

  it.each(['onCreated', 'onHalted', 'onDestroyed'] as const)('endless: %s', async (phase) => {
    const init = { [phase]: '() => { for (;;) {} }', limits: { callTimeoutMs: 150 } };
    const opened = create(init);
    const fault =
      phase === 'onCreated'
        ? await faultFrom(opened)
        : await opened.then(({ sandbox }) =>
            faultFrom(phase === 'onHalted' ? sandbox.halt() : sandbox.destroy()),
          );
    expect(fault).toMatchObject({ kind: 'timeout', phase });
    await isAlive();
  });

  it('endless: the source itself', async () => {
    const onProcessing = '(() => { for (;;) {} })()';
    expect(await faultFrom(create({ onProcessing }))).toMatchObject({ kind: 'timeout' });
    await isAlive();
  });

  it.each(Object.entries(GREEDY))('greedy: %s', async (_, onProcessing) => {
    const { run } = await create({
      onProcessing: `(dt) => { if (dt === 1) return (${onProcessing})() }`,
      limits: { callTimeoutMs: 20_000, memoryBytes: 16 * 1024 * 1024 },
    });
    const before = process.memoryUsage().rss;
    const outcome = await run({ deltaTimeMs: 1 }).catch((fault: { kind: string }) => fault);
    expect('kind' in outcome ? outcome.kind : 'done').toMatch(/memory|threw|timeout/);
    expect(process.memoryUsage().rss - before).toBeLessThan(400 * 1024 * 1024);
    await isAlive();
  });

  it('greedy: pictures that are kept', async () => {
    const { run } = await create({
      onProcessing: '(dt, { image }, state) => { (state.all ??= []).push(image.image2D.data) }',
      // It is about memory, also on a busy machine.
      limits: { callTimeoutMs: 20_000, memoryBytes: 16 * 1024 * 1024 },
    });
    const value = {
      width: 1000,
      height: 500,
      dataFormat: 1,
      data: new Uint8Array(1_500_000),
    } as const;
    const image = recordInput('image', { topic: '/i', format: 'image2D', value });
    let fault: unknown;
    for (let i = 0; i < 30 && fault === undefined; i++) {
      await run({ inputs: [image] }).catch((thrown: unknown) => (fault = thrown));
    }
    expect(fault).toMatchObject({ kind: 'memory' });
    await isAlive();
  });

  it('deep: recursion of every kind ends as an exception or ends the instance', async () => {
    const bodies = [
      'const deep = () => deep() + 1; deep()',
      'const deep = () => [1].map(deep); deep()',
      'let list = []; for (let i = 0; i < 1e5; i++) list = [list]; JSON.stringify(list)',
      'JSON.parse("[".repeat(1e5))',
      'eval("(".repeat(1e5))',
      'eval("[".repeat(1e5))',
      'new RegExp("(?:".repeat(1e5))',
      'let list = []; for (let i = 0; i < 1e5; i++) list = [list]; String(list)',
      'let proxy = {}; for (let i = 0; i < 1e5; i++) proxy = new Proxy(proxy, {}); proxy.x',
      'const self = { toString: () => String(self) }; String(self)',
      'class A { constructor() { new A() } } new A()',
      'const run = (n) => eval("run(n + 1)"); run(0)',
    ];
    for (const body of bodies) {
      expect(await attempt(body)).toMatchObject({
        kind: expect.stringMatching(/threw|crashed|timeout|memory/) as string,
      });
      await isAlive();
    }
  });

  it('long: a source of a megabyte runs, a longer one is refused [PM-57]', async () => {
    const long = (bytes: number) =>
      `() => ({ outputs: { out: { string: 'x' } } }) /*${'x'.repeat(bytes)}*/`;
    const { run } = await create({ onProcessing: long(1_000_000) });
    expect(valuesOf((await run()).outputs)).toEqual({ out: 'x' });
    expect(await faultFrom(create({ onProcessing: long(10_000_000) }))).toMatchObject({
      kind: 'syntax',
    });
  });

  it('others that run meanwhile do not notice', async () => {
    const honest = await create({
      onProcessing:
        '(dt, inputs, state) => ({ outputs: { out: { string: String(state.n = (state.n ?? 0) + 1) } } })',
    });
    await honest.run();
    const bad = await create({
      onProcessing: '() => { for (;;) {} }',
      limits: { callTimeoutMs: 150 },
    });
    const [fault, { outputs }] = await Promise.all([faultFrom(bad.run()), honest.run()]);
    expect(fault.kind).toBe('timeout');
    expect(valuesOf(outputs)).toEqual({ out: '2' });
  });
});
