import { decode, encode, type Init, type IOMapping, type ProcessingModule } from '@ubii/proto';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { instanceId, reconcile, type RunningInstance, type WantedInstance } from './reconcile.ts';

const MODULE = 'ubii.processing.ProcessingModule';
const MAPPING = 'ubii.sessions.IOMapping';

interface Parts {
  readonly module?: Init<ProcessingModule>;
  readonly mapping?: Init<IOMapping>;
}

function wanted(
  id: string,
  { module = {}, mapping = {} }: Parts = {},
  rest: Partial<WantedInstance> = {},
): WantedInstance {
  const spec = {
    module: decode(MODULE, encode(MODULE, { id, ...module })),
    mapping: decode(MAPPING, encode(MAPPING, mapping)),
    isTrusted: false,
  };
  return { spec, isPaused: false, revision: 1, ...rest };
}

const running = (
  as: WantedInstance,
  state: RunningInstance['state'] = 'processing',
  wasStopped = false,
): RunningInstance => ({ as, state, wasStopped });

const words = (...sides: Parameters<typeof reconcile>): string[] =>
  reconcile(...sides).map(({ kind, id }) => `${kind} ${id}`);

const OTHER_CODE: Parts = { module: { onProcessingStringified: '() => 1' } };
const FAULT = { kind: 'missing', phase: '', message: 'no code' } as const;

describe('reconcile()', () => {
  it('makes what is missing, and starts it unless its session is paused [SE-14]', () => {
    expect(words([wanted('a'), wanted('b', {}, { isPaused: true })], [])).toEqual([
      'create a',
      'start a',
      'create b',
    ]);
  });

  it('leaves alone what is as it is wanted', () => {
    expect(words([wanted('a')], [running(wanted('a'))])).toEqual([]);
    const paused = wanted('a', {}, { isPaused: true });
    expect(words([paused], [running(paused, 'ready')])).toEqual([]);
    expect(words([wanted('a', {}, { revision: 2 })], [running(wanted('a'))])).toEqual([]);
  });

  it('ends all that end before it makes anything, then follows the order of what is wanted', () => {
    const now = ['gone', 'changed', 'kept', 'late'].map((id) => running(wanted(id)));
    const next = [
      wanted('new'),
      wanted('late', { module: { processingMode: { free: {} } } }),
      wanted('changed', OTHER_CODE),
      wanted('kept'),
    ];
    expect(words(next, now)).toEqual([
      'destroy gone',
      'destroy changed',
      'create new',
      'start new',
      'setMode late',
      'create changed',
      'start changed',
    ]);
  });

  it('applies mappings, modes and pauses without a restart, in this order [SE-14] [SE-15]', () => {
    const live: Parts = {
      module: { processingMode: { free: {} } },
      mapping: { inputMappings: [{ inputName: 'x', topic: '/x' }] },
    };
    expect(words([wanted('a', live, { isPaused: true })], [running(wanted('a'))])).toEqual([
      'remap a',
      'setMode a',
      'halt a',
    ]);
    expect(words([wanted('a', live)], [running(wanted('a'), 'ready')])).toEqual([
      'remap a',
      'setMode a',
      'start a',
    ]);
  });

  it('makes an instance again that was not wanted for a moment [SE-13]', () => {
    expect(words([wanted('a')], [running(wanted('a'), 'processing', true)])).toEqual([
      'destroy a',
      'create a',
      'start a',
    ]);
  });

  it('tries what failed again when its session or its module changed, not when it is paused [SE-15]', () => {
    const failed = [running(wanted('a'), 'failed')];
    const again = ['destroy a', 'create a', 'start a'];
    expect(words([wanted('a')], failed)).toEqual([]);
    expect(words([wanted('a', {}, { isPaused: true })], failed)).toEqual([]);
    expect(words([wanted('a', {}, { revision: 2 })], failed)).toEqual(again);
    expect(words([wanted('a', OTHER_CODE)], failed)).toEqual(again);
  });

  it('makes again what came to have code, and ends what has none any more [PM-64]', () => {
    const without = wanted('a', {}, { fault: FAULT });
    expect(words([wanted('a')], [running(without, 'failed')])).toContain('create a');
    expect(words([without], [running(wanted('a'))])).toContain('destroy a');
    expect(words([{ ...without, fault: { ...FAULT } }], [running(without, 'failed')])).toEqual([]);
  });
});

const variant = fc.record({
  code: fc.constantFrom('() => 1', '() => 2'),
  hertz: fc.constantFrom(10, 20),
  topic: fc.constantFrom('/a', '/b'),
  isPaused: fc.boolean(),
  revision: fc.constantFrom(1, 2),
  fault: fc.option(fc.constant(FAULT), { nil: undefined, freq: 8 }),
});
const anInstance = fc
  .record({ id: fc.constantFrom('a', 'b', 'c', 'd'), variant })
  .map(({ id, variant: { code, hertz, topic, ...rest } }) =>
    wanted(
      id,
      {
        module: { onProcessingStringified: code, processingMode: { frequency: { hertz } } },
        mapping: { inputMappings: [{ inputName: 'in', topic }] },
      },
      rest,
    ),
  );
const manyWanted = fc.uniqueArray(anInstance, { selector: instanceId });
const manyRunning = fc.uniqueArray(
  fc.record({
    as: anInstance,
    state: fc.constantFrom<RunningInstance['state'][]>('ready', 'processing', 'failed'),
    wasStopped: fc.boolean(),
  }),
  { selector: ({ as }) => instanceId(as) },
);

/** Takes all steps as a node would, and fails at one that does not fit. */
function follow(
  steps: ReturnType<typeof reconcile>,
  before: readonly RunningInstance[],
): RunningInstance[] {
  const present = new Map(before.map((one) => [instanceId(one.as), one]));
  const changed = new Map<string, WantedInstance>();
  for (const step of steps) {
    const one = present.get(step.id);
    expect(one === undefined, `${step.kind} ${step.id}`).toBe(step.kind === 'create');
    if (step.kind === 'destroy') {
      present.delete(step.id);
      continue;
    }
    changed.set(step.id, step.wanted);
    if (step.kind === 'create') {
      const state = step.wanted.fault === undefined ? 'ready' : 'failed';
      present.set(step.id, running(step.wanted, state));
    } else if (one!.state !== 'failed') {
      if (step.kind === 'start') expect(one!.state).toBe('ready');
      if (step.kind === 'halt') expect(one!.state).toBe('processing');
      const state = { start: 'processing', halt: 'ready', remap: one!.state, setMode: one!.state };
      present.set(step.id, { ...one!, state: state[step.kind] as RunningInstance['state'] });
    }
  }
  return [...present].map(([id, one]) => ({ ...one, as: changed.get(id) ?? one.as }));
}

describe('whatever is wanted and runs', () => {
  it('is in line after the steps, which fit what is there', () => {
    fc.assert(
      fc.property(manyWanted, manyRunning, (next, now) => {
        const after = follow(reconcile(next, now), now);
        expect(reconcile(next, after)).toEqual([]);
        expect(after.map(({ as }) => instanceId(as)).sort()).toEqual(next.map(instanceId).sort());
        for (const { as, state } of after) {
          const { isPaused } = next.find((one) => instanceId(one) === instanceId(as))!;
          if (state !== 'failed') expect(state).toBe(isPaused ? 'ready' : 'processing');
        }
      }),
    );
  });

  it('is ended before anything is made, and never kept after it was stopped', () => {
    fc.assert(
      fc.property(manyWanted, manyRunning, (next, now) => {
        const steps = reconcile(next, now);
        const count = steps.filter(({ kind }) => kind === 'destroy').length;
        expect(steps.slice(0, count).every(({ kind }) => kind === 'destroy')).toBe(true);
        const ended = new Set(steps.slice(0, count).map(({ id }) => id));
        for (const { as, wasStopped } of now) {
          if (wasStopped) expect(ended.has(instanceId(as))).toBe(true);
        }
      }),
    );
  });
});
