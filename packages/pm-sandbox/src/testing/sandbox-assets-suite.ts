import { describe, expect, it } from 'vitest';
import { AssetError, missingSet } from '../assets/asset-error.ts';
import { loadedAssets } from './fake-assets.ts';
import { faultFrom, valuesOf, type OpenSandbox, type SandboxInit } from './sandbox-fixture.ts';

const MODEL = loadedAssets('model', { 'weights/a.bin': 'abc' });
const LIBRARY = loadedAssets(
  'counter',
  { 'counter.js': 'var made = (globalThis.made ?? 0) + 1;\n({ made })', 'notes.txt': 'x' },
  'counter.js',
);
const shows = (value: string): string =>
  `(dt, inputs, state) => ({ outputs: { out: { string: JSON.stringify(${value}) } } })`;

/** Asset sets of trusted modules. */
export function describeAssets(create: (init: SandboxInit) => Promise<OpenSandbox>): void {
  const shown = async ({ run }: OpenSandbox): Promise<unknown> =>
    JSON.parse(String(valuesOf((await run()).outputs)['out']));

  describe('asset sets [PM-90]', () => {
    it('are in the state, by name and path', async () => {
      const onProcessing = shows("[...state.assets.model['weights/a.bin']]");
      const one = await create({ assets: [MODEL], onProcessing });
      expect(await shown(one)).toEqual([97, 98, 99]);
      await one.sandbox.destroy();
    });

    it('are none for a module that names none, and cannot be replaced', async () => {
      const one = await create({
        onProcessing: `(dt, inputs, state) => {
          try { state.assets = 1 } catch {}
          return { outputs: { out: { string: JSON.stringify(state.assets) } } };
        }`,
      });
      expect(await shown(one)).toEqual({});
    });

    it('have what ended the instance before beside them, which a new one has not [PM-54]', async () => {
      const onProcessing = shows('state.previousFault ?? "new"');
      const message = 'onProcessing waited longer than 10000 ms.';
      const previousFault = { kind: 'timeout', phase: 'onProcessing', message } as const;
      expect(await shown(await create({ onProcessing, previousFault }))).toEqual(previousFault);
      expect(await shown(await create({ onProcessing, instanceId: 'other' }))).toBe('new');
    });

    it('that are libraries are evaluated once for all instances of a worker [PM-91]', async () => {
      const onProcessing = shows('[state.modules.counter.made, Object.keys(state.assets.counter)]');
      const init = { assets: [LIBRARY, MODEL], onProcessing };
      const [one, two] = [await create(init), await create({ ...init, instanceId: 'other' })];
      expect(await shown(one)).toEqual([1, ['notes.txt']]);
      expect((await shown(two)) as unknown[]).toContainEqual(['notes.txt']);
      await one.sandbox.destroy();
      expect((await shown(two)) as unknown[]).toContainEqual(['notes.txt']);
      await two.sandbox.destroy();
    });

    it('that are libraries which fail end the start of the module', async () => {
      const broken = loadedAssets('broken', { 'a.js': 'throw new Error("no GPU")' }, 'a.js');
      const fault = await faultFrom(create({ assets: [broken] }));
      expect(fault).toMatchObject({ kind: 'library', phase: 'onCreated' });
      expect(fault.message).toBe('The library broken cannot be loaded: no GPU.');
    });
  });

  describe('optional asset sets [PM-96]', () => {
    const load = `async (dt, inputs, state) => {
      const shown = await state.loadAssets('model').then(
        (files) => [Object.keys(files), ...files['weights/a.bin']],
        ({ code, message }) => [code, message],
      );
      return { outputs: { out: { string: JSON.stringify(shown) } } };
    }`;
    const asked: string[] = [];
    const onLoadAssets = (name: string) => {
      asked.push(name);
      return Promise.resolve(MODEL);
    };

    it('are loaded when the module asks for them', async () => {
      const one = await create({ onProcessing: load, onLoadAssets });
      expect(await shown(one)).toEqual([['weights/a.bin'], 97, 98, 99]);
      expect(asked).toEqual(['model']);
      await one.sandbox.destroy();
    });

    it('stay for an instance when another one that has them ends', async () => {
      const [one, two] = [
        await create({ assets: [MODEL], onProcessing: load, onLoadAssets }),
        await create({ onProcessing: load, onLoadAssets, instanceId: 'two' }),
      ];
      expect(await shown(two)).toEqual([['weights/a.bin'], 97, 98, 99]);
      await one.sandbox.destroy();
      expect(await shown(two)).toEqual([['weights/a.bin'], 97, 98, 99]);
      await two.sandbox.destroy();
    });

    it('that are missing or damaged reject with code and reason, and do not end the module', async () => {
      const problems = [missingSet('model'), new AssetError('damaged', 'It is damaged.')];
      const one = await create({
        onProcessing: load,
        onLoadAssets: () => {
          const problem = problems.shift();
          return problem === undefined ? Promise.resolve(MODEL) : Promise.reject(problem);
        },
      });
      expect(await shown(one)).toEqual(['missing', missingSet('model').message]);
      expect(await shown(one)).toEqual(['damaged', 'It is damaged.']);
      // It has arrived meanwhile.
      expect(await shown(one)).toEqual([['weights/a.bin'], 97, 98, 99]);
      await one.sandbox.destroy();
    });
  });
}
