import { describe, expect, it } from 'vitest';
import { faultFrom, valuesOf, type OpenSandbox, type SandboxInit } from './sandbox-fixture.ts';

/** The part of the suite about code that does not end by itself. [PM-53] */
export function describeSandboxLimits(
  create: (init: SandboxInit) => Promise<OpenSandbox>,
  open: (init: SandboxInit) => OpenSandbox,
): void {
  const ENDLESS = {
    'a loop': '() => { for (;;) {} }',
    'a loop after an await': 'async () => { await null; for (;;) {} }',
    'a getter of the result': '() => ({ get outputs() { for (;;) {} } })',
    'a regular expression': '() => /^(a+)+$/.test("a".repeat(40) + "!")',
  };

  describe('limits [PM-53]', () => {
    it.each(Object.entries(ENDLESS))('end %s and name it', async (_, onProcessing) => {
      const { run, killed } = await create({ onProcessing });
      const fault = await faultFrom(run());
      expect(fault).toMatchObject({ kind: 'timeout', phase: 'onProcessing' });
      expect(await killed).toEqual(fault);
    });

    it('end a chain of promises and name it: it uses up its time or its memory', async () => {
      const onProcessing =
        '() => { const next = () => Promise.resolve().then(next); next(); return new Promise(() => {}) }';
      const { run, killed } = await create({ onProcessing });
      const fault = await faultFrom(run());
      expect(fault).toMatchObject({ phase: 'onProcessing' });
      expect(['timeout', 'memory']).toContain(fault.kind);
      expect(await killed).toEqual(fault);
    });

    it('end a loop in onCreated', async () => {
      const { sandbox, killed } = open({
        onCreated: '() => {\n  for (;;) { Math.sqrt(2) }\n}',
        limits: {},
      });
      expect(await faultFrom(sandbox.create())).toMatchObject({ kind: 'timeout' });
      expect(await killed).toMatchObject({ kind: 'timeout', phase: 'onCreated' });
    });

    it('end what takes too much memory', async () => {
      const { run, killed } = await create({
        onProcessing:
          '() => { const all = []; for (;;) all.push(new Array(1000).fill(all.length)) }',
        limits: { callTimeoutMs: 20_000 },
      });
      const fault = await faultFrom(run());
      expect(fault).toMatchObject({ kind: 'memory', phase: 'onProcessing' });
      expect(await killed).toEqual(fault);
    });

    it('survive deep recursion', async () => {
      const { run } = await create({
        onProcessing:
          '(dt) => { const deep = () => deep() + 1; if (dt === 1) deep(); return { outputs: { out: { string: "well" } } } }',
      });
      expect(await faultFrom(run({ deltaTimeMs: 1 }))).toMatchObject({ kind: 'threw' });
      expect(valuesOf((await run()).outputs)).toEqual({ out: 'well' });
    });

    it('let an instance that was killed start again', async () => {
      const init = {
        instanceId: 'again',
        onProcessing:
          '(dt) => { while (dt === 1); return { outputs: { out: { string: "back" } } } }',
      };
      const first = await create(init);
      await faultFrom(first.run({ deltaTimeMs: 1 }));
      const second = await create(init);
      expect(valuesOf((await second.run()).outputs)).toEqual({ out: 'back' });
    });
  });
}
