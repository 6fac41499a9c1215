import { decode, decodeRecord, type Image2D } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import {
  elementsInput,
  recordInput,
  valuesOf,
  type OpenSandbox,
  type SandboxInit,
} from './sandbox-fixture.ts';

/** Acceptance tests of the records that enter and leave a sandbox. [PM-30] to [PM-35] */
export function describeRecords(create: (init: SandboxInit) => Promise<OpenSandbox>): void {
  describe('inputs', () => {
    it('are whole records with type [PM-30]', async () => {
      const { run, lines } = await create({
        onProcessing: '(dt, inputs) => console.log(inputs)',
      });
      const record = {
        topic: '/a',
        format: 'vector2',
        value: { x: 0.25, y: -3 },
        timestampMs: 1_700_000_000_000,
        clientId: 'me',
      } as const;
      await run({ inputs: [recordInput('p', record), { name: 'none', record: undefined }] });
      expect(JSON.parse(lines[0]!.slice('log: '.length))).toEqual({
        p: {
          topic: '/a',
          timestamp: { seconds: 1_700_000_000, nanos: 0, millis: 1_700_000_000_000 },
          vector2: { x: 0.25, y: -3 },
          clientId: 'me',
          type: 'vector2',
        },
      });
    });

    it('are lists of records with identity for muxers [PM-40]', async () => {
      const { run, lines } = await create({
        onProcessing:
          '(dt, { m, e }) => console.log(e, m.elements.map(({ topic, type, double, identity }) => [topic, type, double, identity ?? "-"]))',
      });
      const elements = [
        { topic: '/1', format: 'double', value: 1, identity: 'one' },
        { topic: '/2', format: 'double', value: 2 },
      ] as const;
      await run({ inputs: [elementsInput('m', elements), elementsInput('e', [])] });
      expect(lines).toEqual([
        'log: {"elements":[]} [["/1","double",1,"one"],["/2","double",2,"-"]]',
      ]);
    });

    it('say when the node got an element [PM-49]', async () => {
      const { run, lines } = await create({
        onProcessing:
          '(dt, { m }) => console.log(m.elements.map(({ receivedAtMs }) => receivedAtMs ?? "-"))',
      });
      const elements = [
        { topic: '/1', format: 'double', value: 1, receivedAtMs: 1_800_000_000_000.5 },
        { topic: '/2', format: 'double', value: 2 },
      ] as const;
      await run({ inputs: [elementsInput('m', elements)] });
      expect(lines).toEqual(['log: [1800000000000.5,"-"]']);
    });

    it('carry every number, text and byte through [PM-36]', async () => {
      const { run } = await create({
        outputs: { list: 'doubleList', text: 'string', image: 'image2D' },
        onProcessing: `(dt, { list, text, image }) => {
          if (!(image.image2D.data instanceof Uint8Array)) throw new Error('no bytes');
          return { outputs: { list, text, image } };
        }`,
      });
      const doubles = { elements: [NaN, Infinity, -Infinity, -0, 0.1, 1e300, 2 ** 53] };
      const text = 'ä€😀\u2028"\\\n\u0000';
      const image: Image2D = {
        width: 2,
        height: 2,
        dataFormat: 2,
        data: new Uint8Array(16).map((_, i) => i * 17),
      };
      const { outputs, faults } = await run({
        inputs: [
          recordInput('list', { topic: '/l', format: 'doubleList', value: doubles }),
          recordInput('text', { topic: '/t', format: 'string', value: text }),
          recordInput('image', { topic: '/i', format: 'image2D', value: image }),
        ],
      });
      expect(faults).toEqual([]);
      expect(valuesOf(outputs)).toEqual({ list: doubles, text, image });
    });

    it('survive names of the language itself', async () => {
      const { run, lines } = await create({
        onProcessing: `(dt, inputs) => console.log(Object.keys(inputs), inputs['__proto__'].double, {}.double)`,
      });
      await run({
        inputs: [recordInput('__proto__', { topic: '/', format: 'double', value: 5 })],
      });
      expect(lines).toEqual(['log: ["__proto__"] 5 undefined']);
    });
  });

  describe('outputs', () => {
    it('0, false and empty text are values; undefined is none [PM-32]', async () => {
      const { run } = await create({
        outputs: { a: 'double', b: 'bool', c: 'string', d: 'int32', e: 'int32' },
        onProcessing:
          '() => ({ outputs: { a: { double: 0 }, b: { bool: false }, c: { string: "" }, d: undefined } })',
      });
      const { outputs } = await run();
      expect(valuesOf(outputs)).toEqual({ a: 0, b: false, c: '' });
    });

    it('come in the order they are declared [PM-35]', async () => {
      const { run } = await create({
        outputs: { z: 'double', a: 'double', m: 'double' },
        onProcessing:
          '() => ({ outputs: { a: { double: 1 }, m: { double: 2 }, z: { double: 3 }, other: { double: 4 } } })',
      });
      expect((await run()).outputs.map(({ name }) => name)).toEqual(['z', 'a', 'm']);
    });

    it('keep a timestamp that is given [PM-32]', async () => {
      const { run } = await create({
        outputs: { a: 'double', b: 'double' },
        onProcessing:
          '() => ({ outputs: { a: { double: 1, timestamp: { millis: 1700000000000.5 } }, b: { double: 1 } } })',
      });
      const [a, b] = (await run()).outputs;
      if (!a || !b || !('value' in a) || !('value' in b)) throw new Error('expected two values');
      expect(a.value.hasTimestamp).toBe(true);
      expect(decodeRecord(a.value.bytes).timestampMs).toBe(1_700_000_000_000);
      expect(b.value.hasTimestamp).toBe(false);
      expect(decode('ubii.topicData.TopicDataRecord', b.value.bytes).timestamp).toBeUndefined();
      expect(b.value.valueField).toBe(3);
    });

    it('of a wrong format are refused, the others not [PM-33]', async () => {
      const { run } = await create({
        outputs: { a: 'vector2', b: 'double', c: 'double', d: 'image2D' },
        onProcessing: `() => ({ outputs: {
          a: { vector2: { x: 'left' } }, b: { vector2: { x: 1 } }, c: { double: 3 },
          d: { image2D: { width: 2, height: 2, data: new Uint8Array(3) } },
        } })`,
      });
      const { outputs, faults } = await run();
      expect(valuesOf(outputs)).toEqual({ c: 3 });
      expect(faults.map(({ kind }) => kind)).toEqual(['output', 'output', 'output']);
      expect(faults[0]!.message).toContain('"a"');
      expect(faults[0]!.message).toContain('vector2.x must be a number');
      expect(faults[1]!.message).toContain('double');
    });

    it('of an unknown format take the member that is there [PM-3]', async () => {
      const { run } = await create({
        outputs: { a: undefined, b: undefined },
        onProcessing: '() => ({ outputs: { a: { bool: true }, b: { what: 1 } } })',
      });
      const { outputs, faults } = await run();
      expect(valuesOf(outputs)).toEqual({ a: true });
      expect(faults).toHaveLength(1);
    });

    it('for demuxers are elements with parameters [PM-45] [PM-46] [PM-48]', async () => {
      const { run } = await create({
        outputs: { each: 'double' },
        onProcessing: `() => ({ outputs: { each: { elements: [
          { double: 1, outputTopicParams: ['a', 2] },
          { double: 2, output_params: ['b'] },
          { double: 3, identity: 'me' },
          { double: 'four' },
          { double: 5, outputTopicParams: [{}] },
          null,
          { double: 7 },
        ] } } })`,
      });
      const { outputs, faults } = await run();
      expect(valuesOf(outputs)['each']).toEqual([
        { value: 1, params: ['a', '2'], identity: undefined, index: 0 },
        { value: 2, params: ['b'], identity: undefined, index: 1 },
        { value: 3, params: undefined, identity: 'me', index: 2 },
        { value: 7, params: undefined, identity: undefined, index: 6 },
      ]);
      expect(faults.map(({ message }) => /element (\d)/.exec(message)?.[1])).toEqual([
        '3',
        '4',
        '5',
      ]);
    });

    it('that are lists have a member of their own', async () => {
      const { run } = await create({
        outputs: { list: 'vector2List', floats: 'floatList' },
        onProcessing: `() => ({ outputs: {
          list: { vector2List: { elements: [{ x: 1, y: 2 }] } },
          floats: { floatList: { elements: new Float32Array([0.5, NaN]) } },
        } })`,
      });
      const { outputs, faults } = await run();
      expect(faults).toEqual([]);
      expect(valuesOf(outputs)).toEqual({
        list: { elements: [{ x: 1, y: 2 }] },
        floats: { elements: [0.5, NaN] },
      });
    });

    it('that cannot cross are refused [PM-56]', async () => {
      const { run } = await create({
        outputs: { a: 'double', b: 'vector2', c: 'vector2', d: 'string', e: 'double' },
        onProcessing: `() => {
          const circle = { x: 1 }; circle.y = circle;
          return { outputs: {
            a: { double: () => 1 }, b: { vector2: circle }, c: { get vector2() { throw new Error('no') } },
            d: { string: Symbol('x') }, e: { double: 5 },
          } };
        }`,
      });
      const { outputs, faults } = await run();
      expect(valuesOf(outputs)).toEqual({ e: 5 });
      expect(faults).toHaveLength(4);
    });

    it('have at most so many bytes in a run [PM-55]', async () => {
      const { run } = await create({
        limits: { outputBytes: 1000 },
        outputs: { a: 'string', b: 'string', c: 'double' },
        onProcessing:
          '() => ({ outputs: { a: { string: "x".repeat(600) }, b: { string: "x".repeat(600) }, c: { double: 1 } } })',
      });
      const { outputs, faults } = await run();
      expect(outputs.map(({ name }) => name)).toEqual(['a', 'c']);
      expect(faults).toMatchObject([{ kind: 'flood' }]);
    });

    it('of something that is no result are refused', async () => {
      const { run } = await create({ onProcessing: '() => 7' });
      expect((await run()).faults).toMatchObject([{ kind: 'output', phase: 'onProcessing' }]);
    });
  });
}
