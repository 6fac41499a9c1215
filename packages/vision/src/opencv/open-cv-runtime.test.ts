import { describe, expect, it } from 'vitest';
import { readAssetSet } from '../../scripts/asset-sets.mjs';
import { createOpenCvRuntime } from '../../test/open-cv-set.ts';
import { OPENCV_WASM_FILE, OpenCvRuntime, sharedOpenCv } from './open-cv-runtime.ts';
import type { OpenCvFactory } from './open-cv.ts';

const factory = (): OpenCvFactory =>
  // eslint-disable-next-line no-eval -- as workers of trusted modules do
  (0, eval)(new TextDecoder().decode(readAssetSet('opencv')['opencv.js'])) as OpenCvFactory;

describe('the asset set opencv', () => {
  it('leaves the process and the global object as they were', async () => {
    const listeners = () =>
      process.eventNames().map((name) => [name, process.listenerCount(name as string)]);
    const [before, globals] = [listeners(), Object.getOwnPropertyNames(globalThis)];
    await createOpenCvRuntime().run((cv, keep) => keep(new cv.Mat(1, 1, cv.CV_8UC1)));
    expect(listeners()).toEqual(before);
    expect(Object.getOwnPropertyNames(globalThis)).toEqual(globals);
  });

  it('can be loaded again after a damaged file, which is an error', async () => {
    const broken = new OpenCvRuntime(factory(), { [OPENCV_WASM_FILE]: new Uint8Array([1, 2, 3]) });
    for (let round = 0; round < 2; round++) {
      await expect(broken.run(() => 1)).rejects.toThrow(/OpenCV cannot start: .*bytes/);
    }
    expect(() => new OpenCvRuntime(factory(), {})).toThrow(OPENCV_WASM_FILE);
  });

  it('is one OpenCV for all modules of a worker', () => {
    const [one, other, files] = [factory(), factory(), readAssetSet('opencv')];
    expect(sharedOpenCv(one, files)).toBe(sharedOpenCv(one, files));
    expect(sharedOpenCv(one, files)).not.toBe(sharedOpenCv(other, files));
  });
});

describe('OpenCvRuntime', () => {
  it('deletes what a task kept, also when the task throws', async () => {
    const runtime = createOpenCvRuntime();
    const failed = runtime.run((cv, keep) => {
      keep(new cv.Mat(1000, 1000, cv.CV_8UC1));
      throw new RangeError('mine');
    });
    await expect(failed).rejects.toThrow(RangeError);
    const mat = await runtime.run((cv, keep) => keep(new cv.Mat(2, 2, cv.CV_8UC1)));
    expect(() => mat.clone()).toThrow(/deleted/);
  });
});
