import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { SandboxFactory } from '../ports/sandbox.ts';
import { describeAssets } from './sandbox-assets-suite.ts';
import { describeSandboxLimits } from './sandbox-limits-suite.ts';
import { describeRecords } from './sandbox-records-suite.ts';
import { describeMistakes } from './sandbox-words-suite.ts';
import {
  faultFrom,
  openSandbox,
  valuesOf,
  type OpenSandbox,
  type SandboxInit,
} from './sandbox-fixture.ts';

/** One kind of sandbox under test. */
export interface SandboxSuite {
  createSandboxes(): SandboxFactory | Promise<SandboxFactory>;
  readonly isTrusted: boolean;
  /** False: the code runs on the test's own thread, so nothing can end it. */
  readonly hasLimits: boolean;
}

/** Acceptance tests of the port `SandboxFactory`. */
export function describeSandboxes(name: string, suite: SandboxSuite): void {
  describe(`sandboxes: ${name}`, () => {
    let factory: SandboxFactory;
    beforeAll(async () => {
      factory = await suite.createSandboxes();
    });
    afterAll(() => factory.close());

    const open = (init: SandboxInit): OpenSandbox => openSandbox(factory, init, suite.isTrusted);
    const create = async (init: SandboxInit): Promise<OpenSandbox> => {
      const opened = open(init);
      await opened.sandbox.create();
      return opened;
    };
    /** Runs a body that returns a text once. */
    const textOf = async (body: string, init: SandboxInit = {}): Promise<unknown> => {
      const onProcessing = `(dt, inputs, state) => ({ outputs: { out: { string: String((() => { ${body} })()) } } })`;
      const { run, sandbox } = await create({ ...init, onProcessing });
      const { outputs, faults } = await run();
      await sandbox.destroy();
      return faults[0] ?? valuesOf(outputs)['out'];
    };

    describe('sources [PM-2]', () => {
      it.each([
        ['an arrow function', '() => ({ outputs: { out: { string: "x" } } })'],
        ['a function expression', 'function () { return { outputs: { out: { string: "x" } } } }'],
        ['a method', '({ go() { return { outputs: { out: { string: "x" } } } } }).go'],
        ['an async function', 'async () => ({ outputs: { out: { string: "x" } } })'],
        ['one that ends in a comment', '() => ({ outputs: { out: { string: "x" } } }) // x'],
      ])('runs %s', async (_, onProcessing) => {
        const { run, sandbox } = await create({ onProcessing });
        const result = await run();
        expect(valuesOf(result.outputs)).toEqual({ out: 'x' });
        expect(result.faults).toEqual([]);
        await sandbox.destroy();
      });

      it('does not see variables of the place it runs in', async () => {
        for (const name of ['phase', 'request', 'source', 'text', 'instance']) {
          expect(await textOf(`return typeof ${name}`)).toBe('undefined');
        }
      });

      it('says what does not parse, without ending', async () => {
        const fault = await factory.check({ onProcessing: '() => {\n  const a = ;\n}' });
        expect(fault).toMatchObject({ kind: 'syntax', phase: 'onProcessing' });
        expect(await factory.check({ onProcessing: '() => {}' })).toBeUndefined();
      });

      it('says what is no function', async () => {
        expect(await factory.check({ onProcessing: '7' })).toMatchObject({ kind: 'missing' });
        const { sandbox } = open({ onProcessing: '({})' });
        expect(await faultFrom(sandbox.create())).toMatchObject({
          kind: 'missing',
          phase: 'onProcessing',
        });
      });

      it('refuses a source of 10 MB [PM-57]', async () => {
        const onProcessing = `() => {}//${'x'.repeat(10_000_000)}`;
        expect(await factory.check({ onProcessing })).toMatchObject({ kind: 'syntax' });
      });
    });

    describe('life [PM-10]', () => {
      it('calls onCreated, onProcessing, onHalted and onDestroyed with the state [PM-12]', async () => {
        const { sandbox, run, lines } = await create({
          onCreated: '(state) => { state.count = 1; console.log("created", state.count) }',
          onProcessing:
            '(dt, inputs, state) => { state.count++; console.log("run", dt, state.count) }',
          onHalted: 'async (state) => { await null; console.log("halted", state.count) }',
          onDestroyed: '(state) => { console.log("destroyed", state.count) }',
        });
        await run({ deltaTimeMs: 0 });
        await run({ deltaTimeMs: 33.5 });
        await sandbox.halt();
        await run({ deltaTimeMs: 1 });
        await sandbox.destroy();
        expect(lines).toEqual([
          'log: created 1',
          'log: run 0 2',
          'log: run 33.5 3',
          'log: halted 3',
          'log: run 1 4',
          'log: destroyed 4',
        ]);
      });

      it('takes callbacks that are missing for empty ones', async () => {
        const { sandbox, run } = await create({});
        expect((await run()).outputs).toEqual([]);
        await sandbox.halt();
        await sandbox.destroy();
      });

      it('replaces the state by one that is returned, and keeps the modules [PM-12]', async () => {
        const { run, lines } = await create({
          onProcessing: `(dt, inputs, state) => {
            try { state.modules = 1 } catch {}
            console.log(state.n, typeof state.modules);
            return { state: Object.freeze({ n: (state.n ?? 0) + 1 }) };
          }`,
        });
        await run();
        await run();
        await run();
        expect(lines).toEqual(['log: undefined object', 'log: 1 object', 'log: 2 object']);
      });

      it('tells the inputs that triggered [PM-12]', async () => {
        const { run, lines } = await create({
          onProcessing: '(dt, inputs, state) => console.log(state.inputTriggerNames)',
        });
        await run({ triggers: ['a', 'b'] });
        expect(lines).toEqual(['log: ["a","b"]']);
      });

      it('tells when a run began [PM-15]', async () => {
        const { run, lines } = await create({
          onProcessing: '(dt, inputs, state) => console.log(state.masterTimeMs)',
        });
        await run({ masterTimeMs: 1_800_000_000_000.25 });
        expect(lines).toEqual(['log: 1800000000000.25']);
      });

      it('rejects everything after terminate, and what was pending', async () => {
        const { sandbox, run } = await create({
          onProcessing: 'async () => { await new Promise(() => {}) }',
        });
        const pending = faultFrom(run());
        sandbox.terminate();
        expect(await pending).toHaveProperty('kind');
        expect(await faultFrom(run())).toHaveProperty('kind');
      });
    });

    describe('console [PM-14]', () => {
      it('writes lines with levels', async () => {
        const { lines } = await create({
          onCreated: `() => {
            console.log('a', 1, { b: [2] }, undefined, null, true);
            console.info('i'); console.warn('w'); console.error(new TypeError('e')); console.debug('d');
            const circle = {}; circle.self = circle; console.log(circle);
          }`,
        });
        expect(lines.slice(0, 5)).toEqual([
          'log: a 1 {"b":[2]} undefined null true',
          'info: i',
          'warn: w',
          'error: TypeError: e',
          'debug: d',
        ]);
        expect(lines).toHaveLength(6);
      });

      it('cuts a flood of lines within one call', async () => {
        const { lines, run } = await create({
          onProcessing: '() => { for (let i = 0; i < 1000; i++) console.log(i) }',
        });
        await run();
        await run();
        expect(lines.length).toBeLessThan(250);
        expect(lines.some((line) => line.includes('900 more log lines'))).toBe(true);
      });
    });

    describeRecords(create);

    describe('faults [PM-13]', () => {
      const MULTILINE = {
        'arrow function':
          '(dt, inputs, state) => {\n  const a = 1;\n    throw new Error("here");\n}',
        'one line': '() => { throw new Error("here") }',
        method: '({\n  go() {\n    const a = 1;\n    throw new Error("here");\n  }\n}).go',
        'async function': 'async () => {\n  await null;\n    throw new Error("here");\n}',
        'inner function':
          'function () {\n  const inner = () => {\n    throw new Error("here");\n  };\n  inner();\n}',
      };
      const LINES = {
        'arrow function': 3,
        'one line': 1,
        method: 4,
        'async function': 3,
        'inner function': 3,
      };

      it.each(Object.entries(MULTILINE))('tell line and column: %s', async (kind, onProcessing) => {
        const { run } = await create({ onProcessing });
        const fault = await faultFrom(run());
        expect(fault).toMatchObject({ kind: 'threw', phase: 'onProcessing', message: 'here' });
        expect(fault.line).toBe(LINES[kind as keyof typeof LINES]);
        const line = onProcessing.split('\n')[fault.line! - 1]!;
        // Engines point at the throw, the new or the bracket.
        const start = line.indexOf('throw');
        expect(fault.column).toBeGreaterThanOrEqual(start + 1);
        expect(fault.column).toBeLessThanOrEqual(start + 'throw new Error('.length + 1);
      });

      it('do not end the instance', async () => {
        const { run } = await create({
          onProcessing:
            '(dt, inputs, state) => { state.n = (state.n ?? 0) + 1; if (state.n === 1) throw 7; return { outputs: { out: { string: "n" + state.n } } } }',
        });
        expect(await faultFrom(run())).toMatchObject({ kind: 'threw', message: '7' });
        expect(valuesOf((await run()).outputs)).toEqual({ out: 'n2' });
      });

      it('of onCreated are those of create', async () => {
        const { sandbox } = open({ onCreated: '() => {\n undefined.x\n}' });
        expect(await faultFrom(sandbox.create())).toMatchObject({
          kind: 'threw',
          phase: 'onCreated',
          line: 2,
        });
      });

      it('of things that cannot even be shown are faults', async () => {
        const { run } = await create({
          onProcessing: '() => { throw { get message() { throw 1 }, toString() { throw 2 } } }',
        });
        expect(await faultFrom(run())).toMatchObject({ kind: 'threw' });
      });

      it('name a library the node lacks [PM-4]', async () => {
        const { sandbox } = open({ libraries: ['nowhere'] });
        const fault = await faultFrom(sandbox.create());
        expect(fault.kind).toBe('library');
        expect(fault.message).toContain('nowhere');
      });
    });

    it('runs many instances, each with its own state', async () => {
      const instances = await Promise.all(
        Array.from({ length: 12 }, (_, i) =>
          create({
            onCreated: `(state) => { state.n = ${i} }`,
            onProcessing: `(dt, inputs, state) => ({ outputs: { out: { string: String(state.n += 100) } } })`,
          }),
        ),
      );
      const results = await Promise.all(instances.map(({ run }) => run()));
      expect(results.map(({ outputs }) => valuesOf(outputs)['out'])).toEqual(
        instances.map((_, i) => String(100 + i)),
      );
      await Promise.all(instances.map(({ sandbox }) => sandbox.destroy()));
    });

    if (suite.isTrusted) describeAssets(create);
    describeMistakes(create);
    if (suite.hasLimits) describeSandboxLimits(create, open);
  });
}
