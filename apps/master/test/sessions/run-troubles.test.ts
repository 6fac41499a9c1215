import type { Init, Session } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { codes, SessionWorld, TOPICS } from './session-world.ts';

/** Fails on what is below zero. */
const picky = (code = 'if (inputs.in.double < 0) throw new Error("below zero");') =>
  ({
    name: 'picky',
    processingModules: [
      {
        name: 'picky',
        inputs: [{ internalName: 'in', messageFormat: 'double' }],
        outputs: [{ internalName: 'out', messageFormat: 'double' }],
        processingMode: { triggerOnInput: {} },
        onProcessingStringified: `(deltaTime, inputs) => { ${code} return { outputs: { out: inputs.in } }; }`,
      },
    ],
    ioMappings: [
      {
        processingModuleName: 'picky',
        inputMappings: [{ inputName: 'in', topic: '/in' }],
        outputMappings: [{ outputName: 'out', topic: '/out' }],
      },
    ],
  }) satisfies Init<Session>;

async function createWorld() {
  const world = await SessionWorld.create();
  const session = await world.ask(TOPICS.start, picky());
  const put = async (value: number, seconds = 1): Promise<void> => {
    world.ada.publish('/in', 'double', value);
    for (let i = 0; i < seconds * 20; i++) await world.master.pass(50);
  };
  const now = (): Promise<Session> => world.ask(TOPICS.get, { id: session.id });
  return { world, put, now };
}

describe('a module whose runs fail [SE-12]', () => {
  it('is a problem of its session, with the first cause, until its runs succeed', async () => {
    const { put, now } = await createWorld();
    await put(1);
    expect(codes((await now()).extension?.problems)).not.toContain('module_run_failed');
    await put(-1, 3);
    const [problem] = (await now()).extension!.problems;
    expect(problem).toMatchObject({ code: 'module_run_failed', isError: true });
    expect(problem?.message).toMatch(/^A run of the module "picky" failed: .*below zero.*\.$/);
    await put(-2, 10);
    expect(codes((await now()).extension?.problems)).toContain('module_run_failed');
    await put(1, 7);
    expect(codes((await now()).extension?.problems)).not.toContain('module_run_failed');
  });

  it('is none any more when its code was corrected', async () => {
    const { world, put, now } = await createWorld();
    await put(-1, 2);
    const failing = await now();
    expect(codes(failing.extension?.problems)).toContain('module_run_failed');
    const [module] = failing.processingModules;
    const onProcessingStringified = picky('').processingModules[0]!.onProcessingStringified;
    await world.ask(TOPICS.update, {
      ...failing,
      processingModules: [{ ...module!, onProcessingStringified }],
    });
    await put(-1, 3);
    expect(codes((await now()).extension?.problems)).not.toContain('module_run_failed');
  });
});
