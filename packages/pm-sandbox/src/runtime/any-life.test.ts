import { ProcessingModuleStatus } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import fc from 'fast-check';
import { expect, it } from 'vitest';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { Sandbox, SandboxEvents, SandboxFactory } from '../ports/sandbox.ts';
import { EMPTY_RESULT } from '../testing/fake-sandboxes.ts';
import { createModuleWorld, instanceSpec } from '../testing/module-world.ts';

const MODES = [
  { frequency: { hertz: 50 } },
  { triggerOnInput: { minDelayMs: 10, allInputsNeedUpdate: false } },
  { free: {} },
  { lockstep: { processRequestEndpoint: '' } },
];

const KILLED: ModuleFault = { kind: 'timeout', phase: 'onProcessing', message: 'too long' };
const THREW: ModuleFault = { kind: 'threw', phase: 'onProcessing', message: 'boom' };

/** Sandboxes whose callbacks take time, fail or hang as a list of numbers says. */
class UnreliableSandboxes implements SandboxFactory {
  overlaps = 0;
  openCount = 0;
  readonly #clock: FakeClock;
  readonly #luck: readonly number[];
  #used = 0;
  #kills: (() => void)[] = [];

  constructor(clock: FakeClock, luck: readonly number[]) {
    this.#clock = clock;
    this.#luck = luck;
  }

  killOne(): void {
    this.#kills.shift()?.();
  }

  open(_request: unknown, events: SandboxEvents): Sandbox {
    let underWay: ((fault: ModuleFault) => void) | undefined;
    let isGone = false;
    this.openCount++;
    const end = (fault: ModuleFault) => {
      if (isGone) return;
      isGone = true;
      this.openCount--;
      underWay?.(fault);
    };
    const kill = () => {
      if (isGone) return;
      end(KILLED);
      events.onKilled(KILLED);
    };
    this.#kills.push(kill);
    const call = <T>(result: T): Promise<T> => {
      if (underWay !== undefined || isGone) this.overlaps++;
      const luck = this.#luck[this.#used++ % this.#luck.length]!;
      return new Promise<T>((resolve, reject) => {
        const settle = (fn: () => void) => () => {
          underWay = undefined;
          fn();
        };
        underWay = (fault) => settle(() => reject(fault as unknown as Error))();
        if (luck < 60)
          this.#clock.after(
            luck,
            settle(() => (isGone ? undefined : resolve(result))),
          );
        else if (luck < 80) settle(() => reject(THREW as unknown as Error))();
        else if (luck < 90) this.#clock.after(luck, kill);
      });
    };
    return {
      create: () => call(undefined),
      run: () => call(EMPTY_RESULT),
      halt: () => call(undefined),
      destroy: async () => {
        await call(undefined);
        end(KILLED);
      },
      terminate: () => end(KILLED),
    };
  }

  check(): Promise<undefined> {
    return Promise.resolve(undefined);
  }

  close(): Promise<void> {
    return Promise.resolve();
  }
}

const step = fc.oneof(
  fc
    .constantFrom('create', 'start', 'halt', 'destroy', 'kill', 'put', 'pass', 'remap')
    .map((what) => ({
      what,
      number: 0,
    })),
  fc.record({ what: fc.constant('mode'), number: fc.nat(MODES.length - 1) }),
  fc.record({ what: fc.constant('wait'), number: fc.nat(200) }),
);

it('[PM-10] [PM-29] [PM-54] holds whatever happens: one callback at a time, nothing left behind', async () => {
  await fc.assert(
    fc.asyncProperty(
      fc.array(step, { maxLength: 40 }),
      fc.array(fc.nat(99), { minLength: 1, maxLength: 20 }),
      fc.nat(MODES.length - 1),
      async (steps, luck, mode) => {
        const limits = { haltTimeoutMs: 100, restartDelayMs: 20, maxRestarts: 3 };
        const clock = new FakeClock();
        const sandboxes = new UnreliableSandboxes(clock, luck);
        const world = createModuleWorld(limits, [], { clock, sandboxes });
        const { runtime, topics } = world;
        const spec = instanceSpec({
          mode: MODES[mode]!,
          inputs: { x: 'double' },
          from: { x: '/x' },
        });
        const settled: Promise<unknown>[] = [];
        const act: Record<string, (number: number) => unknown> = {
          create: () => settled.push(runtime.create(spec).catch(() => {})),
          start: () => runtime.start('pm-1'),
          halt: () => settled.push(runtime.halt('pm-1')),
          destroy: () => settled.push(runtime.destroy('pm-1')),
          kill: () => sandboxes.killOne(),
          put: () => topics.put('/x', 'double', 1),
          pass: () => void runtime.runPass({ instanceIds: ['pm-1'], deltaTimeMs: 1, records: [] }),
          remap: () => runtime.remap('pm-1', spec.mapping),
          mode: (number) => runtime.setMode('pm-1', MODES[number]),
          wait: (number) => clock.advance(number),
        };
        for (const { what, number } of steps) await act[what]!(number);
        const closed = runtime.close();
        await clock.advance(1000);
        await closed;
        await Promise.all(settled);
        expect(sandboxes.overlaps).toBe(0);
        expect(sandboxes.openCount).toBe(0);
        expect(runtime.instanceCount).toBe(0);
        expect(topics.subscriptionCount).toBe(0);
        const last = world.statuses.at(-1)?.status;
        if (last !== undefined) expect(last).toBe(ProcessingModuleStatus.DESTROYED);
      },
    ),
    { numRuns: 500 },
  );
});
