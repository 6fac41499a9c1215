import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { EMPTY_RESULT, inputValues } from '../../testing/fake-sandboxes.ts';
import { createModuleWorld, type ModuleSketch } from '../../testing/module-world.ts';

const onInput = (minDelayMs = 0, allInputsNeedUpdate = false) => ({
  triggerOnInput: { minDelayMs, allInputsNeedUpdate },
});

const TWO_INPUTS: ModuleSketch = {
  mode: onInput(),
  inputs: { a: 'double', b: 'double' },
  from: { a: '/a', b: '/b' },
};

describe('a module that is triggered by its inputs', () => {
  it('[PM-23] runs once at the end of a turn, on the newest records of it', async () => {
    const { clock, sandboxes, topics, begin } = createModuleWorld();
    await begin(TWO_INPUTS);
    expect(sandboxes.last.calls).toHaveLength(0);
    topics.put('/a', 'double', 1);
    topics.put('/a', 'double', 2);
    topics.put('/b', 'double', 3);
    expect(sandboxes.last.calls).toHaveLength(0);
    await clock.endTurn();
    expect(sandboxes.last.calls.map(inputValues)).toEqual([{ a: 2, b: 3 }]);
    sandboxes.last.finish();
    await clock.advance(1000);
    expect(sandboxes.last.calls).toHaveLength(1);
  });

  it('[PM-12] is told which inputs were updated', async () => {
    const { clock, sandboxes, topics, begin } = createModuleWorld();
    sandboxes.onRun = () => EMPTY_RESULT;
    await begin(TWO_INPUTS);
    topics.put('/b', 'double', 1);
    await clock.endTurn();
    topics.put('/b', 'double', 1);
    topics.put('/a', 'double', 1);
    await clock.endTurn();
    expect(sandboxes.last.calls.map(({ triggers }) => triggers)).toEqual([['b'], ['a', 'b']]);
  });

  it('[PM-23] waits for all mapped inputs when asked to', async () => {
    const { clock, sandboxes, topics, begin } = createModuleWorld();
    sandboxes.onRun = () => EMPTY_RESULT;
    await begin({
      mode: onInput(0, true),
      inputs: { a: 'double', b: 'double', unmapped: 'double', fixed: 'double' },
      from: { a: '/a', b: '/b', fixed: { constant: { double: 7 } } },
    });
    const put = async (topic: string) => {
      topics.put(topic, 'double', 1);
      await clock.endTurn();
      return sandboxes.last.calls.length;
    };
    expect(await put('/a')).toBe(0);
    expect(await put('/a')).toBe(0);
    expect(await put('/b')).toBe(1);
    expect(await put('/b')).toBe(1);
    expect(await put('/a')).toBe(2);
  });

  it('[PM-24] starts a run that is due too early when the delay ends, once, on the newest inputs', async () => {
    const { clock, sandboxes, topics, runtime, begin } = createModuleWorld();
    sandboxes.onRun = () => EMPTY_RESULT;
    await begin({ ...TWO_INPUTS, mode: onInput(100) });
    topics.put('/a', 'double', 1);
    await clock.advance(30);
    topics.put('/a', 'double', 2);
    await clock.advance(30);
    expect(runtime.statistics()[0]).toMatchObject({ runs: 1, waiting: 1 });
    topics.put('/a', 'double', 3);
    await clock.advance(39);
    expect(sandboxes.last.calls).toHaveLength(1);
    await clock.advance(1);
    expect(sandboxes.last.calls.map((call) => inputValues(call).a)).toEqual([1, 3]);
    await clock.advance(1000);
    expect(sandboxes.last.calls).toHaveLength(2);
    expect(runtime.statistics()[0]).toMatchObject({ waiting: 0 });
  });

  it('[PM-25] keeps triggers that fall into a run: any number is one run', async () => {
    const { clock, sandboxes, topics, runtime, begin } = createModuleWorld();
    await begin(TWO_INPUTS);
    topics.put('/a', 'double', 1);
    await clock.endTurn();
    for (const value of [2, 3, 4]) {
      topics.put('/a', 'double', value);
      await clock.endTurn();
    }
    expect(sandboxes.last.calls).toHaveLength(1);
    expect(runtime.statistics()[0]?.waiting).toBe(1);
    sandboxes.last.finish();
    await clock.endTurn();
    expect(inputValues(sandboxes.last.lastCall)).toEqual({ a: 4, b: undefined });
    sandboxes.last.finish();
    await clock.endTurn();
    expect(sandboxes.last.calls).toHaveLength(2);
  });

  it('[PM-26] runs at its start on values that are there', async () => {
    const { sandboxes, topics, begin } = createModuleWorld();
    topics.put('/a', 'double', 1);
    await begin(TWO_INPUTS);
    expect(sandboxes.last.calls.map(inputValues)).toEqual([{ a: 1, b: undefined }]);
    expect(sandboxes.last.lastCall?.triggers).toEqual(['a']);
  });

  it.each([false, true])(
    '[PM-26] runs once with constants alone; all needed: %s',
    async (allNeeded) => {
      const { clock, sandboxes, begin } = createModuleWorld();
      sandboxes.onRun = () => EMPTY_RESULT;
      await begin({
        mode: onInput(0, allNeeded),
        inputs: { fixed: 'double' },
        from: { fixed: { constant: { double: 7 } } },
      });
      await clock.advance(1000);
      expect(sandboxes.last.calls.map(inputValues)).toEqual([{ fixed: 7 }]);
    },
  );

  it('runs again on what it published itself, one turn later', async () => {
    const { clock, sandboxes, topics, begin } = createModuleWorld();
    await begin({ ...TWO_INPUTS });
    topics.put('/a', 'double', 1);
    await clock.endTurn();
    topics.put('/a', 'double', 2);
    sandboxes.last.finish();
    await clock.endTurn();
    expect(sandboxes.last.calls).toHaveLength(2);
  });

  it('costs one end of turn for many modules', async () => {
    const { clock, sandboxes, topics, begin } = createModuleWorld();
    sandboxes.onRun = () => EMPTY_RESULT;
    for (let i = 0; i < 10; i++) await begin({ ...TWO_INPUTS, id: `pm-${i}` });
    topics.put('/a', 'double', 1);
    topics.put('/b', 'double', 1);
    expect(clock.endOfTurnCount).toBe(1);
    await clock.endTurn();
    expect(sandboxes.opened.map(({ calls }) => calls.length)).toEqual(Array(10).fill(1));
  });

  it('[PM-23] [PM-24] [PM-25] starts runs when a simple model says so', async () => {
    const step = fc.oneof(
      fc.record({ put: fc.constantFrom('/a', '/b') }),
      fc.record({ waitMs: fc.integer({ min: 1, max: 60 }) }),
      fc.constant({ endTurn: true } as const),
    );
    await fc.assert(
      fc.asyncProperty(
        fc.array(step, { maxLength: 40 }),
        fc.constantFrom(0, 25),
        fc.boolean(),
        fc.integer({ min: 0, max: 40 }),
        async (steps, minDelayMs, allNeeded, runMs) => {
          const world = createModuleWorld();
          const { clock, sandboxes, topics } = world;
          const starts: number[] = [];
          sandboxes.onRun = (_call, sandbox) => {
            starts.push(clock.monotonicMs());
            if (runMs === 0) return EMPTY_RESULT;
            clock.after(runMs, () => sandbox.finish());
            return 'pending';
          };
          await world.begin({ ...TWO_INPUTS, mode: onInput(minDelayMs, allNeeded) });
          const model = new TriggerModel(minDelayMs, allNeeded, runMs);
          for (const next of steps) {
            if ('put' in next) {
              topics.put(next.put, 'double', 1);
              model.put(next.put);
            } else if ('waitMs' in next) {
              await clock.advance(next.waitMs);
              model.wait(next.waitMs);
            } else {
              await clock.endTurn();
              model.endTurn();
            }
          }
          expect(starts).toEqual(model.starts);
        },
      ),
      { numRuns: 300 },
    );
  });
});

/** The rules, millisecond by millisecond. */
class TriggerModel {
  readonly starts: number[] = [];
  readonly #minDelayMs: number;
  readonly #allNeeded: boolean;
  readonly #runMs: number;
  readonly #marks = new Set<string>();
  #nowMs = 0;
  #isDue = false;

  constructor(minDelayMs: number, allNeeded: boolean, runMs: number) {
    this.#minDelayMs = minDelayMs;
    this.#allNeeded = allNeeded;
    this.#runMs = runMs;
  }

  put(topic: string): void {
    this.#marks.add(topic);
  }

  endTurn(): void {
    if (this.#allNeeded ? this.#marks.size === 2 : this.#marks.size > 0) this.#isDue = true;
    this.#startIfPossible();
  }

  wait(durationMs: number): void {
    this.endTurn();
    for (let i = 0; i < durationMs; i++) {
      this.#nowMs++;
      this.#startIfPossible();
    }
  }

  #startIfPossible(): void {
    const last = this.starts.at(-1) ?? -Infinity;
    const isBusy = this.#nowMs < last + this.#runMs;
    if (!this.#isDue || isBusy || this.#nowMs < last + this.#minDelayMs) return;
    this.#isDue = false;
    this.#marks.clear();
    this.starts.push(this.#nowMs);
  }
}
