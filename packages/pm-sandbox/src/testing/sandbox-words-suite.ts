import type { DataFormat } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import {
  elementsInput,
  faultFrom,
  recordInput,
  type OpenSandbox,
  type SandboxInit,
} from './sandbox-fixture.ts';

interface Mistake {
  readonly outputs?: Readonly<Record<string, DataFormat | undefined>>;
  /** Return value of onProcessing. */
  readonly returned: string;
  readonly message: string;
}

/** Common mistakes of authors, and the message for each. [PM-33] [PM-56] */
const MISTAKES: Readonly<Record<string, Mistake>> = {
  'a bare number': {
    outputs: { distance: 'double' },
    returned: '{ outputs: { distance: 3 } }',
    message: 'Output "distance": write { double: value }, not a bare number.',
  },
  'a bare array': {
    outputs: { point: 'vector2' },
    returned: '{ outputs: { point: [1, 2] } }',
    message: 'Output "point": write { vector2: { x, y } }, not an array.',
  },
  'a bare array for a list': {
    outputs: { points: 'vector2List' },
    returned: '{ outputs: { points: [] } }',
    message: 'Output "points": write { vector2List: { elements: [ … ] } }, not an array.',
  },
  'the members without the data format': {
    outputs: { point: 'vector2' },
    returned: '{ outputs: { point: { x: 1, y: 2 } } }',
    message: 'Output "point": write { vector2: { x, y } }, not { x, y }.',
  },
  'a misspelt data format': {
    outputs: { distance: 'double' },
    returned: '{ outputs: { distance: { doubel: 1 } } }',
    message: 'Output "distance": write { double: value }, not { doubel }.',
  },
  'no data format at all': {
    outputs: { any: undefined },
    returned: '{ outputs: { any: { what: 1 } } }',
    message:
      'Output "any": write the value under the name of its data format, such as { double: value }, not { what }.',
  },
  'a value of another type': {
    outputs: { distance: 'double' },
    returned: '{ outputs: { distance: { double: "far" } } }',
    message: 'Output "distance": double must be a number, got "far".',
  },
  'undefined in a member': {
    outputs: { distance: 'double' },
    returned: '{ outputs: { distance: { double: undefined } } }',
    message: 'Output "distance": double is undefined. Write { double: value }.',
  },
  'a function': {
    outputs: { distance: 'double' },
    returned: '{ outputs: { distance: { double: () => 1 } } }',
    message: 'Output "distance": double is a function. Write { double: value }.',
  },
  'a promise as an output': {
    outputs: { distance: 'double' },
    returned: '{ outputs: { distance: Promise.resolve({ double: 1 }) } }',
    message:
      'Output "distance": the value is a promise. Make onProcessing async and write await before the value.',
  },
  'a promise as a value': {
    outputs: { distance: 'double' },
    returned: '{ outputs: { distance: { double: Promise.resolve(1) } } }',
    message:
      'Output "distance": the value is a promise. Make onProcessing async and write await before the value.',
  },
  'a promise as all outputs': {
    outputs: { distance: 'double' },
    returned: '{ outputs: Promise.resolve({}) }',
    message:
      'The value of outputs is a promise. Make onProcessing async and write await before the value.',
  },
  'a misspelt output': {
    outputs: { distance: 'double', angle: 'double' },
    returned: '{ outputs: { distnace: { double: 1 } } }',
    message: 'Output "distnace" is not declared. Did you mean "distance"?',
  },
  'an output of no declared name': {
    outputs: { distance: 'double', angle: 'double' },
    returned: '{ outputs: { speed: { double: 1 } } }',
    message: 'Output "speed" is not declared. Declared outputs: "distance", "angle".',
  },
  'outputs without their envelope': {
    outputs: { distance: 'double' },
    returned: '{ distance: { double: 1 } }',
    message: 'onProcessing must return { outputs: { … } }, not { distance }.',
  },
  'a number as the result': {
    outputs: { distance: 'double' },
    returned: '7',
    message: 'onProcessing must return { outputs: { … } }, not a number.',
  },
  'a number as the outputs': {
    outputs: { distance: 'double' },
    returned: '{ outputs: 7 }',
    message: 'outputs must be an object with a member for each output, not a number.',
  },
  'many equal elements': {
    outputs: { each: 'double' },
    returned: '{ outputs: { each: { elements: [{ double: 1 }, 2, 3, 4] } } }',
    message:
      'Output "each", element 1: write { double: value }, not a bare number. The same applies to 2 more elements.',
  },
};

/** The part of the suite about how mistakes of authors are told. */
export function describeMistakes(create: (init: SandboxInit) => Promise<OpenSandbox>): void {
  describe('mistakes are told in the words of the author [PM-33]', () => {
    it.each(Object.entries(MISTAKES))('%s', async (_, { outputs, returned, message }) => {
      const { run } = await create({
        onProcessing: `() => (${returned})`,
        ...(outputs && { outputs }),
      });
      const { faults } = await run();
      expect(faults.map((fault) => fault.message)).toEqual([message]);
      expect(faults[0]).toMatchObject({ kind: 'output', phase: 'onProcessing' });
    });

    it('a returned state without outputs is none', async () => {
      const { run } = await create({
        onProcessing: '(dt, inputs, state) => { state.n = 1; return state; }',
      });
      expect((await run()).faults).toEqual([]);
    });

    const POINT = { topic: '/p', format: 'vector2', value: { x: 1, y: 2 } } as const;
    const INPUTS = [
      { name: 'pointer', record: undefined },
      recordInput('anchor', POINT),
      elementsInput('hands', [POINT]),
    ];
    const READS: readonly (readonly [string, string, string])[] = [
      [
        'an input without a value',
        '(dt, inputs) => {\n  return inputs.pointer.vector2.x;\n}',
        'Input "pointer" has no value yet. Return before you read it: if (!inputs.pointer) return; (TypeError: ',
      ],
      [
        'an input without a value, by its own name',
        '(dt, { anchor, pointer: here }) => {\n  const a = anchor.vector2.x;\n  return a + here.vector2.x;\n}',
        'Input "pointer" has no value yet. Return before you read it: if (!here) return; (TypeError: ',
      ],
      [
        'a misspelt input',
        'function (dt, inputs) {\n  return inputs.ponter.vector2.x;\n}',
        'Input "ponter" is not declared. Did you mean "pointer"? (TypeError: ',
      ],
      [
        'an input that is not connected',
        'async (dt, inputs) => {\n  return inputs.idle.vector2.x;\n}',
        'Input "idle" is not connected. Return before you read it: if (!inputs.idle) return; (TypeError: ',
      ],
    ];
    it.each(READS)('reading %s', async (_, onProcessing, message) => {
      const { run } = await create({
        onProcessing,
        inputs: ['pointer', 'anchor', 'hands', 'idle'],
      });
      const fault = await faultFrom(run({ inputs: INPUTS }));
      expect(fault).toMatchObject({ kind: 'threw', phase: 'onProcessing' });
      expect(fault.message.slice(0, message.length)).toBe(message);
      expect(fault.line).toBe(onProcessing.split('\n').length - 1);
    });

    it('members that are taken from nothing are reported at their line', async () => {
      const { run } = await create({
        onProcessing:
          '(dt, inputs) => {\n  if (!inputs.anchor) return;\n  const { x, y } = inputs.anchor.vector3;\n  return x + y;\n}',
        inputs: ['anchor'],
      });
      const fault = await faultFrom(run({ inputs: INPUTS }));
      expect(fault).toMatchObject({ kind: 'threw', line: 3 });
      expect(fault.message).toContain('inputs.anchor.vector3');
    });

    it('another error keeps its own words', async () => {
      const { run } = await create({
        onProcessing:
          '(dt, inputs) => { throw new Error(`no ${typeof inputs.pointer}`.slice(0, 4)); }',
        inputs: ['pointer'],
      });
      expect(await faultFrom(run({ inputs: INPUTS }))).toMatchObject({ message: 'no u' });
    });
  });
}
