import { Re2Patterns } from '@ubii/patterns/re2';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import type { ModuleFault, SandboxResult } from '@ubii/pm-sandbox';
import { decodeRecord, ModuleEventKind, type ModuleEvent } from '@ubii/proto';
import { FakeClock, settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { moduleOf, type ModuleDraft } from '../../draft/module-draft.ts';
import { TEMPLATES } from '../../draft/templates.ts';
import { leavesOf, newTryInput, recordsOf, tryMapping, withLeaf } from './try-input.ts';
import { TryRun, type TryStatus } from './try-run.ts';

const point = { name: 'point', format: 'vector2', isList: false };
const template = (title: string): ModuleDraft =>
  TEMPLATES.find((one) => one.title === title)!.draft;

function setup() {
  const results: SandboxResult[] = [];
  const events: ModuleEvent[] = [];
  const faults: ModuleFault[] = [];
  const statuses: TryStatus[] = [];
  const failedRuns: true[] = [];
  const clock = new FakeClock();
  const run = new TryRun(createInlineSandboxes(), new Re2Patterns(), clock, {
    onResult: (result) => results.push(result),
    onFailedRun: () => failedRuns.push(true),
    onEvent: (event) => events.push(event),
    onFault: (fault) => faults.push(fault),
    onStatus: (status) => statuses.push(status),
  });
  const put = (draft: ModuleDraft): void => {
    for (const io of draft.inputs) {
      const read = recordsOf(io, newTryInput(io));
      if ('problem' in read) throw new Error(read.problem);
      for (const { topic, bytes } of read.records) run.topics.put(topic, bytes, 'me');
    }
  };
  const open = (draft: ModuleDraft) =>
    run.open(
      moduleOf(draft),
      tryMapping(draft, () => undefined),
    );
  return { run, results, failedRuns, events, faults, statuses, clock, put, open };
}

describe('trying a module', () => {
  it('runs one step on what its inputs hold, and shows what it puts out', async () => {
    const { run, results, put, open } = setup();
    const draft = template('Change each value');
    put(draft);
    await open(draft);
    await run.step();
    const output = results[0]!.outputs[0]!;
    expect('value' in output && decodeRecord(output.value.bytes)).toMatchObject({
      format: 'vector2',
      value: { x: 1, y: 0 },
    });
  });

  it('tells a run that throws, which has no result', async () => {
    const { run, results, failedRuns, open } = setup();
    const code = "onProcessing = () => { throw new Error('no'); };";
    await open({ ...template('Generate'), code });
    await run.step();
    await run.step();
    expect(failedRuns).toHaveLength(2);
    expect(results).toEqual([]);
  });

  it('runs each step that is asked for, also while the module is created', async () => {
    const { run, results, open } = setup();
    const opened = open(template('Generate'));
    await Promise.all([opened, run.step(), run.step()]);
    expect(results).toHaveLength(2);
  });

  it('gives lists an identity for each element [PM-43]', async () => {
    const { run, results, put, open } = setup();
    const draft = template('Many devices');
    put(draft);
    await open(draft);
    await run.step();
    const output = results[0]!.outputs[0]!;
    expect('elements' in output && output.elements.map(({ identity }) => identity)).toEqual([
      '1',
      '2',
    ]);
  });

  it('runs as its mode says, keeps its state over a pause, and steps on', async () => {
    const { run, results, put, open, clock } = setup();
    const draft = template('Generate');
    put(draft);
    await open(draft);
    run.run();
    await clock.advance(200);
    expect(results.length).toBeGreaterThan(3);
    run.pause();
    const ran = results.length;
    await clock.advance(200);
    expect(results.length).toBe(ran);
    await run.step();
    expect(results.length).toBe(ran + 1);
  });

  it('says what failed, and where', async () => {
    const { run, events, put, open } = setup();
    const draft = template('Change each value');
    put(draft);
    await open({ ...draft, code: 'onProcessing = () => {\n  throw new Error("no");\n};\n' });
    await run.step();
    await settle();
    expect(events).toMatchObject([
      { kind: ModuleEventKind.ERROR, phase: 'onProcessing', message: 'no', line: 2 },
    ]);
  });

  it('says what does not fit an output as a session would, whatever engine runs it [PM-33]', async () => {
    const { run, events, put, open } = setup();
    const draft = template('Many devices');
    put(draft);
    const [output] = draft.outputs;
    await open({
      ...draft,
      code: `onProcessing = () => ({ outputs: { ${output!.name}: { ${output!.format}: 1 } } });\n`,
    });
    await run.step();
    await settle();
    expect(events.map(({ message }) => message)).toEqual([
      `Output "${output!.name}" is a list: write { elements: [ … ] }, not a single value.`,
    ]);
  });

  it('says why an instance cannot be made', async () => {
    const { faults, statuses, open } = setup();
    const draft = template('Remember');
    await open({
      ...draft,
      code: `onCreated = () => { throw new Error('never'); };\n${draft.code.slice(draft.code.indexOf('onProcessing'))}`,
    });
    expect(faults).toMatchObject([{ phase: 'onCreated', message: 'never' }]);
    expect(statuses.at(-1)).toBe('failed');
  });
});

describe('values to try with', () => {
  it('come from a form, as far as it has few members', () => {
    const input = newTryInput(point);
    expect(input.source).toBe('form');
    expect(leavesOf(input.values[0]!)).toEqual([
      { path: 'x', value: 0 },
      { path: 'y', value: 0 },
    ]);
    expect(withLeaf({ a: { b: 1 }, c: 2 }, 'a.b', 3)).toEqual({ a: { b: 3 }, c: 2 });
    expect(newTryInput({ ...point, format: 'image2D' }).source).toBe('json');
  });

  it('come from a pasted record, and what is wrong with it is said', () => {
    const input = newTryInput(point);
    const read = (json: string) => recordsOf(point, { ...input, source: 'json', json });
    expect(read('{"topic":"/a","vector2":{"x":1,"y":2}}')).toMatchObject({ records: [{}] });
    expect(read('{"double":1}')).toMatchObject({
      problem: expect.stringContaining('vector2') as string,
    });
    expect(read('{')).toMatchObject({ problem: expect.stringContaining('not JSON') as string });
  });
});
