import { Re2Patterns } from '@ubii/patterns/re2';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import { fromJson, type ProcessingModule } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { RecordLog } from '../../../../topics/history/record-log.ts';
import { aGraphOf, aModule, ref } from '../../../model/testing/small-graph.ts';
import type { Addable } from '../../addable.ts';
import { PREVIEW_MS, previewLines } from './preview-lines.ts';
import { PreviewRun } from './preview-run.ts';
import { isSameTask, previewTask, wishedTopic } from './preview-task.ts';

const START_MS = 1_750_000_000_000;
const sum = (more: object = {}): ProcessingModule =>
  fromJson('ubii.processing.ProcessingModule', {
    name: 'sum',
    inputs: [{ internalName: 'value', messageFormat: 'double' }],
    outputs: [
      { internalName: 'total', messageFormat: 'double' },
      { internalName: 'word', messageFormat: 'string' },
    ],
    processingMode: { triggerOnInput: {} },
    onProcessingStringified: `(deltaTime, { value }, state) => {
      if (value.double === 13) throw new Error('bad luck');
      state.total = (state.total ?? 0) + value.double;
      return { outputs: { total: { double: state.total }, word: { string: 'about ' + deltaTime } } };
    }`,
    ...more,
  });

/** @param past how many of them came before the topic was opened */
function aLog(values: readonly (readonly [ms: number, value: number])[], past = 0): RecordLog {
  const log = new RecordLog(past);
  for (const [ms, value] of values) {
    const localMs = START_MS + ms;
    const record = { topic: '/in', format: 'double', value, clientId: 'c' } as never;
    log.add(record, localMs, localMs, { maxBytes: 1e6, sinceMs: 0 });
  }
  return log;
}
const aRun = (module: ProcessingModule): PreviewRun =>
  new PreviewRun(
    { module, input: 'value', topic: '/in' },
    createInlineSandboxes(),
    new Re2Patterns(),
    START_MS,
  );

describe('a preview', () => {
  it('gives a module the past values, each at its time, then those that come', async () => {
    const run = aRun(sum());
    await run.open();
    const values: [number, number][] = [
      [-500, 7],
      [-10, 1],
      [100, 2],
    ];
    await run.advance(aLog(values), START_MS + 200);
    const { input, outputs } = run.values;
    // Of what was before, the last value holds.
    expect(input.map(({ atMs, numbers }) => [atMs - START_MS, ...numbers])).toEqual([
      [0, 1],
      [100, 2],
    ]);
    expect(outputs.map(({ name, newest }) => [name, newest.value])).toEqual([
      ['total', 3],
      ['word', 'about 100'],
    ]);
    expect(outputs[0]?.numbers.map(({ atMs }) => atMs - START_MS)).toEqual([0, 100]);
    await run.advance(aLog([...values, [6000, 4]]), START_MS + 6000);
    expect(run.values.outputs[0]?.newest.value).toBe(7);
    // The past is forgotten.
    expect(run.values.input.map(({ atMs }) => atMs - START_MS)).toEqual([6000]);
    expect(run.values.outputs[0]?.numbers).toHaveLength(1);
    await run.close();
  });

  it('runs once for each value, also where a run takes time', async () => {
    const inline = createInlineSandboxes();
    const slow: SandboxFactory = {
      ...inline,
      check: (source) => inline.check(source),
      close: () => inline.close(),
      open(request, events) {
        const sandbox = inline.open(request, events);
        return {
          create: () => sandbox.create(),
          halt: () => sandbox.halt(),
          destroy: () => sandbox.destroy(),
          terminate: () => sandbox.terminate(),
          async run(call) {
            await new Promise((resolve) => setTimeout(resolve, 3));
            return sandbox.run(call);
          },
        };
      },
    };
    const run = new PreviewRun(
      { module: sum(), input: 'value', topic: '/in' },
      slow,
      new Re2Patterns(),
      START_MS,
    );
    await run.open();
    const values = Array.from({ length: 20 }, (_, i) => [i * 16.6, 1] as const);
    await run.advance(aLog(values.slice(0, 8)), START_MS + 125);
    await run.advance(aLog(values), START_MS + 340);
    const [total] = run.values.outputs;
    expect(total?.newest.value).toBe(20);
    expect(total?.numbers.map(({ atMs }) => Math.round(atMs - START_MS))).toEqual(
      values.map(([ms]) => Math.round(ms)),
    );
    await run.close();
  });

  it('runs at the time of a value that arrives later than it was measured', async () => {
    const run = aRun(sum());
    await run.open();
    await run.advance(aLog([[0, 1]]), START_MS + 200);
    await run.advance(
      aLog([
        [0, 1],
        [100, 1],
        [116, 1],
      ]),
      START_MS + 325,
    );
    const [total, word] = run.values.outputs;
    expect(total?.numbers.map(({ atMs }) => atMs - START_MS)).toEqual([0, 100, 116]);
    expect(word?.newest.value).toBe('about 16');
    await run.close();
  });

  it('has what came before the topic was opened', async () => {
    const run = aRun(sum());
    await run.open();
    const values = [
      [0, 1],
      [10, 2],
      [20, 4],
    ] as const;
    await run.advance(aLog(values, 2), START_MS + 30);
    expect(run.values.outputs[0]?.newest.value).toBe(7);
    await run.close();
  });

  it('has the error of the module', async () => {
    const run = aRun(sum());
    await run.open();
    await run.advance(aLog([[0, 13]]), START_MS + 10);
    expect(run.fault).toContain('bad luck');
    await run.close();
  });

  it('gives the newest of too many values', async () => {
    const run = aRun(sum());
    await run.open();
    await run.advance(aLog(Array.from({ length: 800 }, (_, i) => [i, 1])), START_MS + 800);
    expect(run.values.outputs[0]?.newest.value).toBe(500);
    await run.close();
  });
});

describe('what can be previewed', () => {
  const graph = aGraphOf(
    [aModule('clock', {}, { sine: 'double' }), aModule('map', { value: 'double' })],
    { 'clock.sine': '/sine', 'map.value': '/sine' },
  );
  const sine = ref(graph, 'clock.sine');
  const [wire] = graph.wires.keys();
  const offer = (module: ProcessingModule): Addable => ({
    key: 'm',
    text: module.name,
    hint: '',
    offer: { kind: 'module', label: module.name, module, port: 'in:value' },
  });

  it('has the topic of an output or a wire', () => {
    expect(wishedTopic(graph, sine, undefined)).toBe('/sine');
    expect(wishedTopic(graph, undefined, wire)).toBe('/sine');
    expect(wishedTopic(graph, ref(graph, 'map.value'), undefined)).toBeUndefined();
    expect(wishedTopic(graph, undefined, undefined)).toBeUndefined();
  });

  it('is a module with code for browsers that needs nothing of its node', () => {
    const taskOf = (more: object) => previewTask(graph, offer(sum(more)), '/sine', undefined);
    expect(taskOf({})).toMatchObject({ input: 'value', topic: '/sine' });
    expect(taskOf({ onProcessingStringified: '' })).toBeUndefined();
    expect(taskOf({ language: 'PY' })).toBeUndefined();
    expect(taskOf({ extension: { libraries: ['http'] } })).toBeUndefined();
    expect(taskOf({ extension: { assets: ['coco'] } })).toBeUndefined();
    expect(taskOf({ processingMode: { free: {} } })).toBeUndefined();
    const misfit = { ...offer(sum()), misfit: 'Does not fit.' };
    expect(previewTask(graph, misfit, '/sine', undefined)).toBeUndefined();
    expect(previewTask(graph, offer(sum()), undefined, undefined)).toBeUndefined();
  });

  it('gets the wire at the input through which it would be inserted', () => {
    const module = sum();
    const item: Addable = { key: 'm', text: 'sum', hint: '', item: { kind: 'module', module } };
    const inserting = wire !== undefined;
    expect(inserting).toBe(true);
    const task = previewTask(graph, item, '/sine', wire)!;
    expect(task.input).toBe('value');
    expect(isSameTask(task, { ...task, module: sum() })).toBe(true);
    expect(isSameTask(task, { ...task, topic: '/other' })).toBe(false);
  });
});

describe('the lines of a preview', () => {
  const span = { fromMs: 0, toMs: PREVIEW_MS, width: 100, height: 10 };
  const at = (ms: number, ...numbers: number[]) => ({ atMs: ms, numbers });

  it('show the number that varies most, in one scale for values of a kind', () => {
    const input = [at(0, 5, 0), at(500, 5, 10)];
    const output = [at(0, 5, 0), at(500, 5, 5)];
    expect(previewLines(input, output, span, true)).toEqual({
      input: 'M0.0 10.0L10.0 0.0',
      output: 'M0.0 10.0L10.0 5.0',
    });
    expect(previewLines(input, [at(0, 1), at(500, 2)], span, false).output).toBe(
      'M0.0 10.0L10.0 0.0',
    );
  });

  it('have a gap where values are missing', () => {
    const input = [at(0, 0), at(500, 10), at(4000, 0), at(4500, 10)];
    expect(previewLines(input, [], span, true).input.match(/M/g)).toHaveLength(2);
  });
});
