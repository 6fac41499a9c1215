import { Re2Patterns } from '@ubii/patterns/re2';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import { fromJson, type ProcessingModule } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { decodedOutput } from '@ubii/recording/compare';
import { differenceWords, outputFacts } from './case-words.ts';
import {
  caseTimeNs,
  compareCaseOutputs,
  isSame,
  type CaseOutput,
  type Exactness,
} from './compare-outputs.ts';
import {
  caseText,
  encodeCaseRecord,
  readCase,
  type CaseRecord,
  type ModuleCase,
} from './module-case.ts';
import { runCase } from './run-case.ts';

const moduleWith = (body: string, mode: object): ProcessingModule =>
  fromJson('ubii.processing.ProcessingModule', {
    name: 'doubler',
    inputs: [{ internalName: 'value', messageFormat: 'double' }],
    outputs: [{ internalName: 'out', messageFormat: 'double' }],
    processingMode: mode,
    onProcessingStringified: `(deltaTime, inputs, state) => { ${body} }`,
  });
const TRIGGER = { triggerOnInput: {} };
const DOUBLE = 'return { outputs: { out: { double: inputs.value.double * 2 } } };';
const records = (topic: string, values: readonly number[], stepMs = 10): CaseRecord[] =>
  values.map((value, index) => ({
    atMs: (index + 1) * stepMs,
    topic,
    publisherId: 'mara',
    record: { double: value },
  }));
const aCase = (module: ProcessingModule, change: Partial<ModuleCase> = {}): ModuleCase => ({
  name: 'doubler in Study',
  startMs: 0,
  durationMs: 100,
  tolerance: 1e-6,
  module,
  mapping: fromJson('ubii.sessions.IOMapping', {
    inputMappings: [{ inputName: 'value', topic: '/in' }],
    outputMappings: [{ outputName: 'out', topic: '/out' }],
  }),
  devices: [],
  before: [{ atMs: 0, topic: '/in', publisherId: 'mara', record: { double: 50 } }],
  inputs: records('/in', [1, 2, 3]),
  outputs: records('/out', [2, 4, 6]),
  ...change,
});
const run = (theCase: ModuleCase) =>
  runCase(theCase, theCase.module, createInlineSandboxes(), new Re2Patterns());

describe('a test case of a module', () => {
  it('passes when the module makes the same of its inputs', async () => {
    const result = await run(aCase(moduleWith(DOUBLE, TRIGGER)));
    expect(result).toMatchObject({
      isPassed: true,
      fault: undefined,
      topics: [{ topic: '/out', same: 3, different: 0, missing: 0, additional: 0 }],
    });
  });

  it('fails with the first output that differs', async () => {
    const body = 'return { outputs: { out: { double: inputs.value.double > 1 ? 0 : 2 } } };';
    const { isPassed, topics } = await run(aCase(moduleWith(body, TRIGGER)));
    expect(isPassed).toBe(false);
    expect(topics[0]!.different).toBe(2);
    expect(differenceWords(topics[0]!)).toBe('At 0.020 s double is 0; recorded: 4.');
    expect(outputFacts(topics[0]!)).toBe('1 as recorded, 2 different');
  });

  it('has the recorded time, for modules with a frequency and in lockstep', async () => {
    // In lockstep it gets the time between passes, otherwise that since the last run.
    const body = 'return { outputs: { out: { double: deltaTime } } };';
    const of = async (mode: object, outputs: readonly CaseRecord[]) =>
      (await run(aCase(moduleWith(body, mode), { outputs }))).topics[0];
    const often = records('/out', [20, 20, 20, 20, 20], 20);
    expect(await of({ frequency: { hertz: 50 } }, often)).toMatchObject({
      same: 5,
      different: 0,
    });
    const passes = records(
      '/out',
      Array.from({ length: 6 }, () => 1000 / 60),
      1000 / 60,
    );
    expect(await of({ lockstep: {} }, passes)).toMatchObject({ same: 6, different: 0 });
  });

  it('fails with the error of the module', async () => {
    const result = await run(aCase(moduleWith("throw new Error('no');", TRIGGER)));
    expect(result.isPassed).toBe(false);
    expect(result.fault).toContain('no');
  });

  it('refuses modules that run freely', async () => {
    await expect(run(aCase(moduleWith(DOUBLE, { free: {} })))).rejects.toThrow('freely');
  });

  it('is the same after it was a file', async () => {
    const theCase = aCase(moduleWith(DOUBLE, TRIGGER));
    expect(readCase(caseText(theCase))).toEqual(theCase);
    expect(() => readCase('{}')).toThrow('not a test case');
    expect(() => readCase('no')).toThrow('not JSON');
    const earlier = JSON.stringify({ ...JSON.parse(caseText(theCase)), devices: undefined });
    expect(readCase(earlier)).toEqual(theCase);
    const strange = JSON.stringify({ ...JSON.parse(caseText(theCase)), devices: [{ id: 1 }] });
    expect(() => readCase(strange)).toThrow('"devices"');
    const broken = JSON.stringify({ ...JSON.parse(caseText(theCase)), inputs: [1] });
    expect(() => readCase(broken)).toThrow('"inputs"');
  });
});

const EXACT = { tolerance: 0, durationMs: 1000 };

const outputsOf = (all: readonly CaseRecord[]): CaseOutput[] =>
  all.map((one) => ({
    topic: one.topic,
    timeNs: caseTimeNs(one.atMs),
    record: decodedOutput(encodeCaseRecord(one)),
  }));
/** Compares the outputs of one topic. */
async function compare(
  recorded: readonly CaseRecord[],
  run: readonly CaseRecord[],
  exactness: Partial<Exactness> = {},
) {
  const [topic] = await compareCaseOutputs(recorded, outputsOf(run), { ...EXACT, ...exactness });
  return topic!;
}
const out = (values: readonly number[]): CaseRecord[] => records('/out', values);

describe('outputs of a case', () => {
  it('may be earlier or later where the module runs at a rhythm', async () => {
    const [recorded, run] = [out([1, 1, 2, 2, 2]), out([1, 1, 1, 2])];
    expect(isSame(await compare(recorded, run))).toBe(false);
    const near = { windowMs: 15 };
    expect(await compare(recorded, run, near)).toMatchObject({
      same: 5,
      different: 0,
      missing: 0,
      additional: 0,
    });
    const others = out([1, 1, 3, 3, 3, 3, 3, 3, 3]);
    const different = await compare(recorded, others, near);
    expect(different).toMatchObject({ same: 2, different: 3, additional: 4 });
    expect(differenceWords(different)).toBe('At 0.030 s double is 3; recorded: 2.');
    // What belongs to the last ones may come after the end.
    expect(await compare(recorded, others, { ...near, durationMs: 50 })).toMatchObject({
      same: 2,
      different: 1,
      missing: 2,
    });
  });

  it('are the same when some are missing at the edges only', async () => {
    const recorded = out([1, 2, 3, 4, 5]);
    const shifted = await compare(recorded, out([2, 3, 4, 5, 6]));
    expect(shifted).toMatchObject({ same: 4, different: 0, missing: 1, additional: 1, atEdges: 2 });
    expect(isSame(shifted)).toBe(true);
    expect(outputFacts(shifted)).toBe(
      '4 as recorded, 1 missing, 1 additional, at the edges of the span, which is accepted',
    );
    expect(differenceWords(shifted)).toBe(undefined);
    const repeating = await compare(out([1, 1, 1, 2, 1, 1]), out([1, 1, 2, 1, 1, 1]));
    expect(isSame(repeating)).toBe(true);
    expect(isSame(await compare(recorded, []))).toBe(false);
    expect(isSame(await compare(recorded, out([5, 6, 7, 8, 9])))).toBe(false);
  });

  it('are not the same when one is missing or additional between others', async () => {
    const recorded = out([1, 2, 3, 4, 5, 6, 7, 8]);
    const missing = await compare(recorded, out([1, 2, 3, 5, 6, 7, 8]));
    expect(missing).toMatchObject({ same: 7, different: 0, missing: 1, atEdges: 0 });
    expect(isSame(missing)).toBe(false);
    expect(outputFacts(missing)).toBe('7 as recorded, 1 missing');
    expect(differenceWords(missing)).toBe('At 0.040 s an output is missing. Recorded: 4.');
    const additional = await compare(recorded, out([1, 2, 3, 4, 9, 5, 6, 7, 8]));
    expect(isSame(additional)).toBe(false);
    expect(differenceWords(additional)).toBe('At 0.050 s there is an additional output: 9.');
  });

  it('may differ within the tolerance, and leave out defaults', async () => {
    const at = (record: CaseRecord['record']): CaseRecord[] => [
      { atMs: 0, topic: '/out', publisherId: '', record },
    ];
    const values = (a: CaseRecord['record'], b: CaseRecord['record'], tolerance = 0.01) =>
      compare(at(a), at(b), { tolerance });
    const near = { vector2: { x: 100.5 } };
    expect((await values({ vector2: { x: 100, y: 0 } }, near)).same).toBe(1);
    expect((await values({ vector2: { x: 0 } }, { vector2: { x: 0.005 } })).same).toBe(1);
    const far = await values({ vector2: { x: 100 } }, { vector2: { x: 102 } });
    expect(differenceWords(far)).toBe('At 0.000 s vector2.x is 102; recorded: 100.');
    expect((await values({ string: 'a' }, { string: 'b' })).different).toBe(1);
    expect((await values({ bool: false }, { bool: true })).different).toBe(1);
  });
});
