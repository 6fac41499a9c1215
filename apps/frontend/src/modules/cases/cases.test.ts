import { Re2Patterns } from '@ubii/patterns/re2';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import { fromJson, type ProcessingModule } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { compareCaseOutputs, isSame } from './compare-outputs.ts';
import { caseText, readCase, type CaseRecord, type ModuleCase } from './module-case.ts';
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
    ...{ atMs: (index + 1) * stepMs, topic, publisherId: 'mara' },
    record: { double: value },
  }));
const aCase = (module: ProcessingModule, change: Partial<ModuleCase> = {}): ModuleCase => ({
  ...{ name: 'doubler in Study', startMs: 0, durationMs: 100, tolerance: 1e-6, module },
  mapping: fromJson('ubii.sessions.IOMapping', {
    inputMappings: [{ inputName: 'value', topic: '/in' }],
    outputMappings: [{ outputName: 'out', topic: '/out' }],
  }),
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
      topics: [{ topic: '/out', matched: 3, different: 0, missing: 0, additional: 0 }],
    });
  });

  it('fails with the first output that differs', async () => {
    const body = 'return { outputs: { out: { double: inputs.value.double > 1 ? 0 : 2 } } };';
    const { isPassed, topics } = await run(aCase(moduleWith(body, TRIGGER)));
    expect(isPassed).toBe(false);
    expect(topics[0]).toMatchObject({
      different: 2,
      first: { atMs: 20, path: 'double', recorded: 4 },
    });
  });

  it('has the recorded time, for modules with a frequency and in lockstep', async () => {
    // In lockstep it gets the time between passes, otherwise that since the last run.
    const body = 'return { outputs: { out: { double: deltaTime } } };';
    const of = async (mode: object, outputs: readonly CaseRecord[]) =>
      (await run(aCase(moduleWith(body, mode), { outputs }))).topics[0];
    const often = records('/out', [20, 20, 20, 20, 20], 20);
    expect(await of({ frequency: { hertz: 50 } }, often)).toMatchObject({
      matched: 5,
      different: 0,
    });
    const passes = records(
      '/out',
      Array.from({ length: 6 }, () => 1000 / 60),
      1000 / 60,
    );
    expect(await of({ lockstep: {} }, passes)).toMatchObject({ matched: 6, different: 0 });
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
    const broken = JSON.stringify({ ...JSON.parse(caseText(theCase)), inputs: [1] });
    expect(() => readCase(broken)).toThrow('"inputs"');
  });
});

const EXACT = { tolerance: 0, durationMs: 1000 };

describe('outputs of a case', () => {
  it('may be earlier or later where the module runs at a rhythm', () => {
    const [recorded, run] = [records('/out', [1, 1, 2, 2, 2]), records('/out', [1, 1, 1, 2])];
    expect(compareCaseOutputs(recorded, run, EXACT)[0]).toMatchObject({ different: 1 });
    const near = { ...EXACT, windowMs: 15 };
    expect(compareCaseOutputs(recorded, run, near)[0]).toMatchObject({
      ...{ matched: 5, different: 0, missing: 0, additional: 0 },
    });
    const others = records('/out', [1, 1, 3, 3, 3, 3, 3, 3, 3]);
    expect(compareCaseOutputs(recorded, others, near)[0]).toMatchObject({
      ...{ matched: 2, different: 3, additional: 3, first: { atMs: 30 } },
    });
    // What belongs to the last ones may come after the end.
    const short = { ...near, durationMs: 50 };
    expect(compareCaseOutputs(recorded, others, short)[0]).toMatchObject({
      ...{ matched: 2, different: 1, missing: 2 },
    });
  });

  it('are the same when some are missing at the edges only', () => {
    const recorded = records('/out', [1, 2, 3, 4, 5]);
    const [shifted] = compareCaseOutputs(recorded, records('/out', [2, 3, 4, 5, 6]), EXACT);
    expect(shifted).toMatchObject({ matched: 4, different: 0, missing: 1, additional: 1 });
    expect(isSame(shifted!)).toBe(true);
    const [none] = compareCaseOutputs(recorded, [], EXACT);
    expect(isSame(none!)).toBe(false);
  });

  it('may differ within the tolerance, and leave out defaults', () => {
    const at = (record: CaseRecord['record']): CaseRecord[] => [
      { atMs: 0, topic: '/out', publisherId: '', record },
    ];
    const compare = (a: CaseRecord['record'], b: CaseRecord['record'], tolerance = 0.01) =>
      compareCaseOutputs(at(a), at(b), { ...EXACT, tolerance })[0]!;
    expect(compare({ vector2: { x: 100, y: 0 } }, { vector2: { x: 100.5 } }).matched).toBe(1);
    expect(compare({ vector2: { x: 100 } }, { vector2: { x: 102 } }).first?.path).toBe('vector2.x');
    expect(compare({ string: 'a' }, { string: 'b' }).different).toBe(1);
    expect(compare({ bool: false }, { bool: true }).different).toBe(1);
  });
});
