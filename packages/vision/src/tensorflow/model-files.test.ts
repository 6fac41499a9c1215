import { describe, expect, it } from 'vitest';
import { readModelFiles } from './model-files.ts';

const json = (value: unknown) => new TextEncoder().encode(JSON.stringify(value));
const model = {
  format: 'graph-model',
  modelTopology: { node: [] },
  weightsManifest: [
    {
      paths: ['a.bin', 'b.bin'],
      weights: [
        { name: 'x', shape: [2], dtype: 'float32' },
        { name: 'y', shape: [2, 1], dtype: 'float32', quantization: { dtype: 'float16' } },
      ],
    },
  ],
};

describe('readModelFiles', () => {
  it('joins the weights in the order of the manifest', () => {
    const files = {
      'm.json': json(model),
      'b.bin': Uint8Array.of(7, 8, 9, 10, 11, 12),
      'a.bin': Uint8Array.of(1, 2, 3, 4, 5, 6),
    };
    const { weightData, weightSpecs } = readModelFiles(files, 'm.json');
    expect([...new Uint8Array(weightData as ArrayBuffer)]).toEqual([
      1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12,
    ]);
    expect(weightSpecs?.map(({ name }) => name)).toEqual(['x', 'y']);
  });

  it.each([
    ['a missing model', {}, 'The file "m.json" of the model "m.json" is missing.'],
    [
      'missing weights',
      { 'm.json': json(model), 'a.bin': new Uint8Array(6) },
      'The file "b.bin" of the model "m.json" is missing.',
    ],
    [
      'cut weights',
      { 'm.json': json(model), 'a.bin': new Uint8Array(6), 'b.bin': new Uint8Array(5) },
      'The weights of "m.json" have 11 bytes instead of 12. Download the model again.',
    ],
    [
      'a cut model',
      { 'm.json': json(model).slice(0, 20) },
      '"m.json" is not valid JSON. Download the model again.',
    ],
    ['something else', { 'm.json': json([1]) }, '"m.json" is not a graph model of TensorFlow.js.'],
    ['null', { 'm.json': json(null) }, '"m.json" is not a graph model of TensorFlow.js.'],
    [
      'a layers model',
      { 'm.json': json({ ...model, format: 'layers-model' }) },
      '"m.json" is not a graph model of TensorFlow.js.',
    ],
  ])('names the file: %s', (_what, files, message) => {
    expect(() => readModelFiles(files as Record<string, Uint8Array>, 'm.json')).toThrow(message);
  });
});
