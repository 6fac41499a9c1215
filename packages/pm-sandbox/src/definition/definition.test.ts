import {
  decode,
  encode,
  ProcessingModuleLanguage,
  type Init,
  type ProcessingModule,
} from '@ubii/proto';
import { describe, expect, expectTypeOf, it } from 'vitest';
import { DEFAULT_RUNTIME_LIMITS } from '../limits.ts';
import { MAX_SOURCE_BYTES } from '../sandbox-limits.ts';
import { callbackSource } from './callback-source.ts';
import { defineProcessingModule } from './define-processing-module.ts';
import { MAX_CHOICE_CHARACTERS, MAX_CHOICES, MAX_IO_DESCRIPTION_CHARACTERS } from './io-limits.ts';
import type { ModuleRecord } from './io-types.ts';
import { moduleProblems } from './module-problems.ts';
import { moduleToWire } from './module-to-wire.ts';
import { parseModule } from './parse-module.ts';

const mirror = defineProcessingModule({
  name: 'mirror',
  inputs: { pointer: 'vector2', touches: { format: 'vector2', list: true } },
  outputs: { mirrored: 'vector2', each: { format: 'bool', list: true } },
  libraries: ['http'],
  mode: { triggerOnInput: { minDelayMs: 5 } },
  createState: () => ({ count: 0 }),
  onCreated(state) {
    state.count = 1;
  },
  onProcessing(_deltaTimeMs, { pointer, touches }, state) {
    expectTypeOf(pointer).toEqualTypeOf<ModuleRecord<'vector2'> | undefined>();
    expectTypeOf(state.count).toEqualTypeOf<number>();
    expectTypeOf(state.inputTriggerNames).toEqualTypeOf<readonly string[]>();
    state.count++;
    if (pointer === undefined) return;
    return {
      outputs: {
        mirrored: { vector2: { x: 1 - pointer.vector2.x, y: pointer.vector2.y } },
        each: { elements: touches.elements.map((touch) => ({ bool: touch.vector2.x > 0.5 })) },
      },
    };
  },
});

const full = (init: Init<ProcessingModule>): ProcessingModule =>
  decode(
    'ubii.processing.ProcessingModule',
    encode('ubii.processing.ProcessingModule', { name: 'm', ...init }),
  );

const evaluate = (source: string): ((...args: unknown[]) => unknown) =>
  // eslint-disable-next-line no-eval -- the test is about what the text evaluates to
  (0, eval)(`(${source}\n)`) as (...args: unknown[]) => unknown;

describe('moduleToWire', () => {
  const wire = moduleToWire(mirror);

  it('tells name, formats, mode, language and libraries', () => {
    expect(full(wire)).toMatchObject({
      name: 'mirror',
      inputs: [
        { internalName: 'pointer', messageFormat: 'ubii.dataStructure.Vector2' },
        { internalName: 'touches', isRecordList: true },
      ],
      outputs: [{ internalName: 'mirrored' }, { messageFormat: 'bool', isRecordList: true }],
      processingMode: { triggerOnInput: { minDelayMs: 5, allInputsNeedUpdate: false } },
      language: ProcessingModuleLanguage.JS,
      extension: { libraries: ['http'] },
      onHaltedStringified: '',
    });
  });

  it('tells descriptions, defaults and choices, and leaves out what a definition lacks [PM-5] [PM-6] [PM-7]', () => {
    const { inputs, outputs } = moduleToWire(
      defineProcessingModule({
        name: 'm',
        inputs: {
          backend: {
            format: 'string',
            default: 'auto',
            description: 'What computes.',
            choices: ['auto', 'cpu'],
          },
          plain: 'double',
        },
        outputs: { durationMs: { format: 'double', description: 'Time of a run, ms.' } },
        onProcessing(_deltaTimeMs, { backend }) {
          expectTypeOf(backend).toEqualTypeOf<ModuleRecord<'string'> | undefined>();
        },
      }),
    );
    expect(inputs).toEqual([
      {
        internalName: 'backend',
        messageFormat: 'string',
        isRecordList: false,
        defaultJson: '{"string":"auto"}',
        description: 'What computes.',
        choices: ['auto', 'cpu'],
      },
      { internalName: 'plain', messageFormat: 'double', isRecordList: false },
    ]);
    expect(outputs).toMatchObject([{ description: 'Time of a run, ms.' }]);
  });

  it('makes texts that evaluate to the callbacks, the first state with them [PM-2]', () => {
    const state: Record<string, unknown> = {};
    evaluate(wire.onCreatedStringified!)(state);
    expect(state).toEqual({ count: 1 });
    const created = moduleToWire({ ...mirror, onCreated: undefined }).onCreatedStringified!;
    evaluate(created)(state);
    expect(state).toEqual({ count: 0 });
  });
});

describe('callbackSource [PM-2]', () => {
  const object = {
    method() {
      return 'method';
    },
    async later() {
      return 'later';
    },
    'with-dash'() {
      return 'dash';
    },
    arrow: () => 'arrow',
    single: (x: unknown) => x ?? 'single',
    expression: function () {
      return 'expression';
    },
    named: function inner() {
      return 'named';
    },
  };

  it.each(Object.entries(object))('%s', async (name, fn) => {
    const again = evaluate(callbackSource(fn, name));
    expect(await again()).toBe(await (fn as () => unknown)());
  });

  it('brings along what build tools put in to keep the names of functions', () => {
    const text = `function () { const inner = __name(() => 7, 'inner'); return inner(); }`;
    const fn = evaluate(text);
    expect(evaluate(callbackSource(fn, 'fn'))()).toBe(7);
  });

  it('refuses what has no source', () => {
    expect(() => callbackSource((() => 1).bind(undefined), 'onHalted')).toThrow(
      'onHalted is bound',
    );
    expect(() => callbackSource(7, 'onHalted')).toThrow('must be a function');
  });
});

describe('parseModule', () => {
  it('takes no mode, and no sensible frequency, for 30 Hz, and limits it [PM-20]', () => {
    const mode = (hertz?: number) =>
      parseModule(
        full({ processingMode: hertz === undefined ? undefined : { frequency: { hertz } } }),
      ).mode;
    expect(mode()).toEqual({ kind: 'frequency', hertz: 30 });
    expect(mode(0)).toEqual({ kind: 'frequency', hertz: 30 });
    expect(mode(-5)).toEqual({ kind: 'frequency', hertz: 30 });
    expect(mode(12)).toEqual({ kind: 'frequency', hertz: 12 });
    expect(mode(1e9)).toEqual({ kind: 'frequency', hertz: DEFAULT_RUNTIME_LIMITS.maxFrequencyHz });
  });

  it('reads data formats leniently and leaves unknown ones open [PM-3]', () => {
    const inputs = ['vector2_list', 'boolean', 'ubii.dataStructure.Image', 'my.own.Format'].map(
      (messageFormat, i) => ({ internalName: `${i}`, messageFormat }),
    );
    const formats = parseModule(full({ inputs })).inputs.map(({ format }) => format);
    expect(formats).toEqual(['vector2List', 'bool', 'image2D', undefined]);
    expect(moduleProblems(full({ inputs }))).toEqual([]);
  });

  it('has no source when there is no code', () => {
    expect(parseModule(full({ onProcessingStringified: '  ' })).source).toBeUndefined();
    expect(parseModule(full(moduleToWire(mirror))).source?.onHalted).toBeUndefined();
  });
});

describe('moduleProblems', () => {
  it('finds names that are empty or taken [PM-3]', () => {
    const outputs = ['a', '', 'a'].map((internalName) => ({ internalName }));
    expect(moduleProblems(full({ name: ' ', outputs })).map(({ path }) => path)).toEqual([
      'name',
      'outputs[1].internalName',
      'outputs[2].internalName',
    ]);
  });

  it('finds descriptions that are longer than a sentence [PM-6]', () => {
    const io = (length: number) => ({ internalName: 'a', description: 'x'.repeat(length) });
    const fine = io(MAX_IO_DESCRIPTION_CHARACTERS);
    const long = io(MAX_IO_DESCRIPTION_CHARACTERS + 1);
    expect(moduleProblems(full({ inputs: [fine], outputs: [fine] }))).toEqual([]);
    expect(moduleProblems(full({ inputs: [long], outputs: [long] }))).toEqual([
      {
        path: 'inputs[0].description',
        message: 'The description has 201 characters; the limit is 200.',
      },
      {
        path: 'outputs[0].description',
        message: 'The description has 201 characters; the limit is 200.',
      },
    ]);
  });

  it.each([
    ['an empty one', ['a', ''], 'is empty'],
    ['one that is there twice', ['a', 'b', 'a'], '"a" is there twice'],
    ['a long one', ['x'.repeat(MAX_CHOICE_CHARACTERS + 1)], 'has 101 characters'],
    ['too many', Array.from({ length: MAX_CHOICES + 1 }, (_, i) => `${i}`), 'has 101 choices'],
  ])('finds choices that cannot be chosen from: %s [PM-7]', (_words, choices, message) => {
    const inputs = [{ internalName: 'a', messageFormat: 'string', choices }];
    expect(moduleProblems(full({ inputs }))).toEqual([
      { path: 'inputs[0].choices', message: expect.stringContaining(message) },
    ]);
  });

  it('takes choices of inputs for one string only [PM-7]', () => {
    const choices = ['a', 'b'];
    const of = (format: object) => full({ inputs: [{ internalName: 'a', choices, ...format }] });
    expect(moduleProblems(of({ messageFormat: 'string' }))).toEqual([]);
    for (const format of [
      { messageFormat: 'double' },
      { messageFormat: 'string', isRecordList: true },
    ]) {
      expect(moduleProblems(of(format)).map(({ path }) => path)).toEqual(['inputs[0].choices']);
    }
    const outputs = [{ internalName: 'a', messageFormat: 'string', choices }];
    expect(moduleProblems(full({ outputs })).map(({ path }) => path)).toEqual([
      'outputs[0].choices',
    ]);
  });

  it('misses onProcessing beside other callbacks, but not in modules without code [PM-1]', () => {
    expect(moduleProblems(full({}))).toEqual([]);
    expect(moduleProblems(full({ onCreatedStringified: '() => {}' }))[0]?.path).toBe(
      'onProcessingStringified',
    );
  });

  it('measures the source in bytes [PM-57]', () => {
    const source = (text: string) => full({ onProcessingStringified: text });
    expect(moduleProblems(source('x'.repeat(MAX_SOURCE_BYTES)))).toEqual([]);
    expect(moduleProblems(source('x'.repeat(MAX_SOURCE_BYTES + 1)))).toHaveLength(1);
    expect(moduleProblems(source('ü'.repeat(MAX_SOURCE_BYTES / 2 + 1)))).toHaveLength(1);
    expect(moduleProblems(source('😀'.repeat(MAX_SOURCE_BYTES / 4)))).toEqual([]);
  });
});
