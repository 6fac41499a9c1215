import type { Picture } from '../src/picture.ts';
import type { Files } from '../src/tensorflow/memory-platform.ts';

/** Cells in a row of the picture that the tiny model looks at. */
export const CELLS = 16;
/** Detected classes: pure red is a person, pure green a stop sign, pure blue a toothbrush. */
const FOUND = [
  { index: 0, weights: [40, -40, -40] },
  { index: 12, weights: [-40, 40, -40] },
  { index: 89, weights: [-40, -40, 40] },
] as const;
/** Classes of the real model: numbers of COCO's categories, less one, with gaps. */
const CLASSES = 90;
/** Sigmoid of -20 is 2e-9: never found. Half a colour gives 0.5. */
const BIAS = -20;

interface Node {
  readonly name: string;
  readonly op: string;
  readonly input?: readonly string[];
  readonly attr?: object;
}

const float = { type: 'DT_FLOAT' };
const int = { type: 'DT_INT32' };
const shapeOf = (...sizes: number[]) => ({ dim: sizes.map((size) => ({ size: String(size) })) });

/**
 * Makes a graph model with the signature of coco-ssd: int32 picture in, scores [1, N, 90] and boxes
 * [1, N, 1, 4] out, N the cells. A cell has the colour of its middle, and its box is 4 × 4 cells
 * around it.
 */
export function tinyCocoSsd(): Files {
  const cells = CELLS ** 2;
  const kernel = new Float32Array(3 * CLASSES);
  for (const { index, weights } of FOUND) {
    for (const [channel, weight] of weights.entries()) kernel[channel * CLASSES + index] = weight;
  }
  const boxes = Float32Array.from({ length: cells * 4 }, (_, at) => {
    const cell = Math.floor(at / 4);
    const middle = (at % 2 === 0 ? Math.floor(cell / CELLS) : cell % CELLS) + 0.5;
    return (middle + (at % 4 < 2 ? -2 : 2)) / CELLS;
  });
  const weights = [
    { name: 'size', dtype: 'int32', shape: [2], values: Int32Array.of(CELLS, CELLS) },
    { name: 'scale', dtype: 'float32', shape: [], values: Float32Array.of(1 / 255) },
    { name: 'kernel', dtype: 'float32', shape: [1, 1, 3, CLASSES], values: kernel },
    {
      name: 'bias',
      dtype: 'float32',
      shape: [CLASSES],
      values: new Float32Array(CLASSES).fill(BIAS),
    },
    { name: 'list', dtype: 'int32', shape: [3], values: Int32Array.of(1, cells, CLASSES) },
    { name: 'all_boxes', dtype: 'float32', shape: [1, cells, 1, 4], values: boxes },
  ];
  const node: Node[] = [
    ...weights.map(({ name, dtype, shape }) => ({
      name,
      op: 'Const',
      attr: {
        dtype: dtype === 'int32' ? int : float,
        value: {
          tensor: {
            dtype: dtype === 'int32' ? 'DT_INT32' : 'DT_FLOAT',
            tensorShape: shapeOf(...shape),
          },
        },
      },
    })),
    {
      name: 'image_tensor',
      op: 'Placeholder',
      attr: { dtype: int, shape: { shape: shapeOf(1, -1, -1, 3) } },
    },
    { name: 'cast', op: 'Cast', input: ['image_tensor'], attr: { SrcT: int, DstT: float } },
    {
      name: 'resize',
      op: 'ResizeBilinear',
      input: ['cast', 'size'],
      attr: { T: float, align_corners: { b: false }, half_pixel_centers: { b: true } },
    },
    { name: 'scaled', op: 'Mul', input: ['resize', 'scale'], attr: { T: float } },
    {
      name: 'conv',
      op: 'Conv2D',
      input: ['scaled', 'kernel'],
      attr: {
        T: float,
        strides: { list: { i: ['1', '1', '1', '1'] } },
        dilations: { list: { i: ['1', '1', '1', '1'] } },
        padding: { s: btoa('SAME') },
        data_format: { s: btoa('NHWC') },
      },
    },
    {
      name: 'biased',
      op: 'BiasAdd',
      input: ['conv', 'bias'],
      attr: { T: float, data_format: { s: btoa('NHWC') } },
    },
    { name: 'sigmoid', op: 'Sigmoid', input: ['biased'], attr: { T: float } },
    { name: 'scores', op: 'Reshape', input: ['sigmoid', 'list'], attr: { T: float, Tshape: int } },
    { name: 'boxes', op: 'Identity', input: ['all_boxes'], attr: { T: float } },
  ];
  const tensor = (name: string, dtype: string, ...sizes: number[]) => ({
    name: `${name}:0`,
    dtype,
    tensorShape: shapeOf(...sizes),
  });
  const model = {
    format: 'graph-model',
    modelTopology: { node, library: {}, versions: {} },
    signature: {
      inputs: { image_tensor: tensor('image_tensor', 'DT_INT32', 1, -1, -1, 3) },
      outputs: {
        'scores:0': tensor('scores', 'DT_FLOAT', 1, cells, CLASSES),
        'boxes:0': tensor('boxes', 'DT_FLOAT', 1, cells, 1, 4),
      },
    },
    weightsManifest: [
      {
        paths: ['group1-shard1of1'],
        weights: weights.map(({ name, dtype, shape }) => ({ name, dtype, shape })),
      },
    ],
  };
  const bytes = weights.flatMap(({ values }) => [
    ...new Uint8Array(values.buffer, values.byteOffset, values.byteLength),
  ]);
  return {
    'model.json': new TextEncoder().encode(JSON.stringify(model)),
    'group1-shard1of1': Uint8Array.from(bytes),
  };
}

/** White, 320 × 240, with squares of one of the model's cells: 20 × 15 pixels. */
export function squares(...list: { x: number; y: number; rgb: readonly number[] }[]): Picture {
  const [width, height] = [320, 240];
  const data = new Uint8Array(width * height * 3).fill(255);
  for (const { x, y, rgb } of list) {
    for (let row = y; row < y + 15; row++) {
      for (let column = x; column < x + 20; column++) data.set(rgb, (row * width + column) * 3);
    }
  }
  return { width, height, format: 'RGB8', data };
}
