import { describe, expect, it } from 'vitest';
import { recordInput, valuesOf } from '../../src/testing/index.ts';
import { untrustedSandboxes } from './fixture.ts';

/** Results that try to be more than data on this side. */
const RESULTS = {
  'a key __proto__': `JSON.parse('{"__proto__":{"polluted":1},"x":1}')`,
  'a nested __proto__': `({ x: 1, ["__proto__"]: { polluted: 1 }, constructor: { prototype: { polluted: 1 } } })`,
  'constructor.prototype': `({ x: 1, constructor: { prototype: { polluted: 1 } } })`,
  toJSON: `({ toJSON: () => ({ x: 1, polluted: 1, __proto__: { polluted: 1 } }) })`,
  'a getter': `({ get x() { return 1 }, get __proto__() { return { polluted: 1 } } })`,
  'a Proxy': `new Proxy({}, { ownKeys: () => ['x', '__proto__'], get: (_, key) => key === 'x' ? 1 : { polluted: 1 }, getOwnPropertyDescriptor: () => ({ enumerable: true, configurable: true, value: 1 }) })`,
  'marks of ours': `({ x: 1, y: { $: '__proto__' }, polluted: { $: 99 } })`,
};

describe('nothing that crosses changes the other side [PM-56]', () => {
  const { create } = untrustedSandboxes();

  it.each(Object.entries(RESULTS))('%s', async (_, expression) => {
    const { run, sandbox } = await create({
      outputs: { out: 'vector2', other: 'string' },
      onProcessing: `() => ({ outputs: { out: { vector2: ${expression} }, other: { string: 'well' } } })`,
    });
    const { outputs } = await run();
    expect(valuesOf(outputs)['other']).toBe('well');
    expect(({} as { polluted?: unknown }).polluted).toBeUndefined();
    expect(Object.keys(Object.prototype)).toEqual([]);
    sandbox.terminate();
  });

  it('a module that breaks its own language breaks only itself', async () => {
    const breakers = [
      'JSON.stringify = () => "no json"',
      'JSON.parse = () => { throw 1 }',
      'Promise.prototype.then = () => { throw 1 }',
      'Object.prototype.toJSON = () => 7',
      'Array.prototype[Symbol.iterator] = null',
      'String.prototype.slice = null',
      'globalThis.Uint8Array = null',
      'Object.prototype.get = () => 1',
      'Object.freeze(Object.prototype)',
      'Map.prototype.get = () => { throw 1 }',
      'Reflect.apply = null; Function.prototype.call = null; Function.prototype.apply = null',
      'Object.defineProperty(Object.prototype, "$", { value: 0 })',
      'Object.defineProperty(Array.prototype, "0", { set() { throw 1 }, get() { throw 2 } })',
    ];
    const honest = await create({
      onProcessing: '(dt, { a }) => ({ outputs: { out: { string: a.string } } })',
    });
    for (const breaker of breakers) {
      const { run, sandbox } = await create({
        onProcessing: `(dt, inputs, state) => { try { ${breaker} } catch {} console.log('x'); return { outputs: { out: { string: 'x' } } } }`,
      });
      await run().catch(() => undefined);
      await run().catch(() => undefined);
      sandbox.terminate();
      const { outputs } = await honest.run({
        inputs: [recordInput('a', { topic: '/', format: 'string', value: 'fine' })],
      });
      expect(valuesOf(outputs)).toEqual({ out: 'fine' });
    }
  });

  it('results that are no data are refused', async () => {
    const { run } = await create({
      outputs: {
        a: 'vector2',
        b: 'image2D',
        c: 'vector2',
        d: 'string',
        e: 'stringList',
        f: 'string',
      },
      onProcessing: `() => {
        const deep = []; let at = deep; for (let i = 0; i < 3000; i++) { at.push([]); at = at[0] }
        return { outputs: {
          a: { vector2: { x: 10n } }, b: { image2D: { width: 1, height: 1, data: () => 1 } },
          c: { vector2: deep }, d: { string: { toJSON() { throw new Error('no') } } },
          e: { stringList: { elements: new Proxy([], { get() { throw new Error('no') } }) } }, f: { string: 'well' },
        } };
      }`,
    });
    const { outputs, faults } = await run();
    expect(valuesOf(outputs)).toEqual({ f: 'well' });
    expect(faults.map(({ kind }) => kind)).toEqual([
      'output',
      'output',
      'output',
      'output',
      'output',
    ]);
  });

  it('an output flood of one run is cut [PM-55]', async () => {
    const { run } = await create({
      outputs: { many: 'string' },
      limits: { callTimeoutMs: 20_000, outputBytes: 10_000 },
      onProcessing: `() => ({ outputs: { many: { elements: Array.from({ length: 5000 }, (_, i) => ({ string: 'x'.repeat(100), identity: String(i) })) } } })`,
    });
    const { outputs, faults } = await run();
    const [many] = outputs;
    expect(many && 'elements' in many ? many.elements.length : 0).toBeLessThan(100);
    expect(faults[0]).toMatchObject({ kind: 'flood' });
    expect(faults.length).toBeLessThan(50);
  });

  it('a state as big as the memory allows stays where it is', async () => {
    const { run } = await create({
      onProcessing: `(dt, inputs, state) => { state.big ??= 'x'.repeat(8_000_000); return { state: { ...state, n: (state.n ?? 0) + 1 }, outputs: { out: { string: String(state.n) } } } }`,
    });
    await run();
    expect(valuesOf((await run()).outputs)).toEqual({ out: '1' });
  });
});
