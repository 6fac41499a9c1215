import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Object2DList } from '@ubii/proto';
import { squares, tinyCocoSsd } from '@ubii/vision/testing/coco-ssd';
import { afterAll, afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { DrivenModule } from '../../test/drive-module.ts';
import { driveWithVision } from '../../test/vision-assets.ts';
import { objectDetection } from './object-detection.ts';

/** `models/` of a data directory. */
const models = mkdtempSync(join(tmpdir(), 'ubii-models-'));
afterAll(() => rmSync(models, { recursive: true }));

// TensorFlow.js advises against how the library of COCO-SSD runs a model without loops, as the tiny one is.
beforeEach(() => {
  vi.spyOn(console, 'warn').mockReturnValue();
  rmSync(join(models, 'coco-ssd'), { recursive: true, force: true });
});
afterEach(() => vi.restoreAllMocks());

/** Puts the files of a model into the folder, as a person would. */
function install(files: { readonly [name: string]: Uint8Array }): void {
  const folder = join(models, 'coco-ssd');
  mkdirSync(folder, { recursive: true });
  for (const [name, bytes] of Object.entries(files)) writeFileSync(join(folder, name), bytes);
}

/** White, with a red square in the middle: a person of the tiny model, and nothing for CenterNet. */
const { width, height, data } = squares({ x: 160, y: 120, rgb: [255, 0, 0] });
const RED_SQUARE = { width, height, dataFormat: 1, data: new Uint8Array(data) };

/** As few pixels as a detector takes: CenterNet detects again and again while a model is loaded. */
const INPUTS = { image: RED_SQUARE, inputSize: 128 };

interface Results {
  predictions?: Object2DList;
  error?: string;
  backend?: string;
}

/** One image; the module is asked again until what it gives is as expected. */
function looker(module: DrivenModule) {
  const look = async (parameters: object = {}): Promise<Results> =>
    (await module.run(1000, { ...INPUTS, ...parameters }, ['image'])) as Results;
  const lookUntil = async (
    isDone: (results: Results) => boolean,
    parameters: object = {},
  ): Promise<Results> => {
    for (let given = parameters; ; given = {}) {
      const results = await look(given);
      if (isDone(results)) return results;
      // Files are read and the test may time out meanwhile.
      await new Promise((resolve) => setImmediate(resolve));
    }
  };
  return { look, lookUntil };
}
const hasError = ({ error }: Results) => error !== undefined;
const classes = ({ predictions }: Results) => predictions?.elements.map(({ id }) => id);

it('detects with COCO-SSD, chosen while it runs, and with CenterNet again', async () => {
  install(tinyCocoSsd());
  const { look, lookUntil } = looker(await driveWithVision(objectDetection, { models }));
  expect(classes(await look())).toEqual([]);
  // CenterNet goes on while the model is loaded.
  expect(classes(await look({ detector: 'coco-ssd' }))).toEqual([]);
  const found = await lookUntil((results) => classes(results)?.length === 1);
  const [person] = found.predictions!.elements;
  expect(person!.id).toBe('person');
  // The square is in cell 8 of 16, and its box reaches 2 cells around the middle of that.
  expect(person!.pose?.position?.x).toBeCloseTo(6.5 / 16);
  expect(person!.pose?.position?.y).toBeCloseTo(6.5 / 16);
  expect(person!.size?.x).toBeCloseTo(4 / 16);
  expect((JSON.parse(person!.userDataJson) as { score: number }).score).toBeGreaterThan(0.99);
  await lookUntil((results) => classes(results)?.length === 0, { detector: undefined });
}, 60_000);

it('each detector has its own threshold where none is given', async () => {
  // Halfway to red scores 0.5, a little less is below the default of COCO-SSD and above that of CenterNet.
  const grey = squares({ x: 160, y: 120, rgb: [127, 0, 0] });
  const image = { ...RED_SQUARE, data: new Uint8Array(grey.data) };
  install(tinyCocoSsd());
  const { look, lookUntil } = looker(await driveWithVision(objectDetection, { models }));
  await lookUntil((results) => classes(results)?.length === 1, { detector: 'coco-ssd' });
  expect(classes(await look({ image }))).toEqual([]);
  expect(classes(await look({ image, threshold: 0.4 }))).toEqual(['person']);
}, 60_000);

it('says how to get a model that is missing, continues with CenterNet, and uses it when it arrives', async () => {
  const { lookUntil } = looker(await driveWithVision(objectDetection, { models }));
  const missing = await lookUntil(hasError, { detector: 'coco-ssd' });
  expect(missing.error).toContain('npm run models -- get coco-ssd');
  expect(classes(missing)).toEqual([]);
  install(tinyCocoSsd());
  // Another choice is looked at without delay.
  await lookUntil(({ error }) => error === '', { detector: 'centernet' });
  await lookUntil((results) => classes(results)?.length === 1, { detector: 'coco-ssd' });
}, 60_000);

it('names what is damaged in a model', async () => {
  const files = tinyCocoSsd();
  install({ ...files, 'group1-shard1of1': files['group1-shard1of1']!.slice(1) });
  const { lookUntil } = looker(await driveWithVision(objectDetection, { models }));
  const { error } = await lookUntil(hasError, { detector: 'coco-ssd' });
  expect(error).toMatch(/^COCO-SSD cannot be used: The weights of "model.json" have \d+ bytes/);
}, 60_000);

it('says why a backend is not used, and which one is', async () => {
  const { lookUntil } = looker(await driveWithVision(objectDetection, { models }));
  const refused = await lookUntil(hasError, { backend: 'webgl' });
  expect(refused).toMatchObject({
    backend: 'wasm',
    error: 'wasm instead of webgl: WebGL in workers needs OffscreenCanvas, which is missing here.',
  });
  expect(await lookUntil(hasError, { backend: 'auto' })).toMatchObject({ error: '' });
}, 60_000);
