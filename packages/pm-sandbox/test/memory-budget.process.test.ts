import { afterEach, describe, expect, it } from 'vitest';
import { createNodeSandboxes } from '../src/node/index.ts';
import type { SandboxFactory } from '../src/index.ts';
import {
  faultFrom,
  openSandbox,
  type OpenSandbox,
  type SandboxInit,
} from '../src/testing/index.ts';
import { WORKER_FILE } from './build-worker.ts';

const MIB = 1024 * 1024;
/** Keeps so many more megabytes with each run. */
const KEEPS = (megabytes: number): string =>
  `(dt, inputs, state) => { for (let i = 0; i < ${megabytes}; i++) (state.all ??= []).push(new Uint8Array(${MIB}).fill(i + 1)) }`;
const LIMITS = { callTimeoutMs: 20_000, memoryBytes: 64 * MIB };

const factories: SandboxFactory[] = [];
afterEach(() => Promise.all(factories.splice(0).map((factory) => factory.close())));

/** Sandboxed instances in two workers with so much memory for all of them, and for those of an owner. */
function budget(memoryBytes: number, ownerMemoryBytes = memoryBytes) {
  const factory = createNodeSandboxes({
    workerFile: WORKER_FILE,
    maxWorkers: 2,
    memoryBytes,
    ownerMemoryBytes,
  });
  factories.push(factory);
  const create = async (init: SandboxInit): Promise<OpenSandbox> => {
    const opened = openSandbox(factory, { limits: LIMITS, ...init }, false);
    await opened.sandbox.create();
    return opened;
  };
  return { create, memory: factory.memory! };
}

describe('memory of all instances of a node [PM-58]', () => {
  it('is told for each: one that keeps nothing takes little', async () => {
    const { create, memory } = budget(256 * MIB);
    const told: number[] = [];
    const idle = await create({ onMemory: (bytes) => told.push(bytes) });
    await expect.poll(() => told.at(-1)).toBeGreaterThan(0);
    await idle.run();
    expect(told.at(-1)).toBeLessThan(2 * MIB);
    expect(memory.leastBytes).toBeLessThanOrEqual(told.at(-1)!);
    const greedy = await create({ onProcessing: KEEPS(10), onMemory: (bytes) => told.push(bytes) });
    await greedy.run();
    expect(told.at(-1)).toBeGreaterThan(10 * MIB);
    expect(told.at(-1)).toBeLessThan(20 * MIB);
    expect(memory.usedBytes()).toBeGreaterThan(10 * MIB);
  });

  it('is bounded: an instance that grows beyond it is ended with the reason, the others continue', async () => {
    const { create, memory } = budget(64 * MIB);
    const all = await Promise.all(
      Array.from({ length: 12 }, () => create({ onProcessing: KEEPS(20) })),
    );
    const outcomes = await Promise.all(
      all.map(({ run }) =>
        run().then(
          () => 'well',
          (fault: unknown) => fault,
        ),
      ),
    );
    const faults = outcomes.filter((outcome) => outcome !== 'well');
    expect(faults.length).toBeGreaterThanOrEqual(9);
    expect(faults.length).toBeLessThan(12);
    for (const fault of faults) {
      expect(fault).toMatchObject({ kind: 'memory', shortage: 'all' });
      expect((fault as Error).message).toMatch(
        /^onProcessing needs more memory than is left of the 64 MB that all modules of this node share/,
      );
    }
    expect(memory.usedBytes()).toBeLessThanOrEqual(64 * MIB);
    const after = await create({ onProcessing: KEEPS(1) });
    await after.run();
  });

  it('is bounded for the instances of one owner, and left to others', async () => {
    const { create, memory } = budget(256 * MIB, 48 * MIB);
    const one = await create({ owner: 'session', onProcessing: KEEPS(30) });
    await one.run();
    const other = await create({ owner: 'session', onProcessing: KEEPS(30) });
    expect(await faultFrom(other.run())).toMatchObject({
      kind: 'memory',
      shortage: 'owner',
      message:
        'onProcessing needs more memory than is left of the 48 MB that the modules of one session share on this node.',
    });
    expect(memory.usedBytes('session')).toBeGreaterThan(30 * MIB);
    const foreign = await create({ owner: 'another session', onProcessing: KEEPS(30) });
    await foreign.run();
    expect(memory.usedBytes('another session')).toBeGreaterThan(30 * MIB);
  });

  it('comes back when instances end, also with their worker', async () => {
    const { create, memory } = budget(64 * MIB);
    for (let i = 0; i < 6; i++) {
      const { sandbox, run } = await create({ onProcessing: KEEPS(40) });
      await run();
      await sandbox.destroy();
    }
    const { run } = await create({
      onProcessing: `(dt, inputs, state) => { (${KEEPS(40)})(dt, inputs, state); const all = []; for (let i = 0; i < 4e6; i++) all.push(i % 7); for (;;) all.sort() }`,
      limits: { ...LIMITS, callTimeoutMs: 300 },
    });
    expect(await faultFrom(run())).toMatchObject({
      kind: expect.stringMatching(/timeout|memory/) as string,
    });
    for (let i = 0; i < 3; i++) {
      const again = await create({ onProcessing: KEEPS(40) });
      await again.run();
      await again.sandbox.destroy();
    }
    expect(memory.usedBytes()).toBeLessThan(2 * MIB);
  });

  it('does not suffice for a start: the instance is refused with the reason', async () => {
    const { create } = budget(4 * MIB);
    const refused = await Promise.all(
      Array.from({ length: 16 }, () =>
        create({}).then(
          () => undefined,
          (fault: unknown) => fault,
        ),
      ),
    );
    expect(refused.filter((fault) => fault === undefined).length).toBeGreaterThan(2);
    expect(refused.find((fault) => fault !== undefined)).toMatchObject({
      kind: 'memory',
      shortage: 'all',
    });
  });
});
