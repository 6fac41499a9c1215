import type { Object2DList } from '@ubii/proto';
import { photoFile } from '@ubii/vision/testing';
import { beforeAll, describe, expect, it } from 'vitest';
import type { DrivenModule } from '../../test/drive-module.ts';
import { driveWithVision, photoImage } from '../../test/vision-assets.ts';
import { bodyPose } from './body-pose.ts';

let module: DrivenModule;
beforeAll(async () => {
  module = await driveWithVision(bodyPose);
}, 60_000);

/** One image, later than the rate asks for. */
const detect = async (image: unknown, parameters: object = {}) =>
  (await module.run(1000, { image, ...parameters }, ['image'])) as {
    keypoints?: Object2DList;
    score?: number;
    backend?: string;
    backendFault?: string;
    error?: string;
  };
type Results = Awaited<ReturnType<typeof detect>>;
/** Sends images until a result is as expected: backends are loaded meanwhile. */
async function until(isDone: (results: Results) => boolean, parameters: object = {}) {
  for (let given = parameters; ; given = {}) {
    const results = await detect(photoImage('astronaut.jpg'), given);
    if (isDone(results)) return results;
    await new Promise((resolve) => setImmediate(resolve));
  }
}
const placeOf = ({ keypoints }: { keypoints?: Object2DList }, name: string) =>
  keypoints?.elements.find(({ id }) => id === name)?.pose?.position;

describe('body-pose', () => {
  // Measured with a ruler on the picture; within 3 % of it.
  it('finds a face where a person puts it, in raw pixels and in a JPEG', async () => {
    const files = { width: 0, height: 0, dataFormat: 0, data: photoFile('astronaut.jpg') };
    for (const image of [photoImage('astronaut.jpg'), files]) {
      const found = await detect(image, { smoothingMs: 0 });
      const { x = 0, y = 0 } = placeOf(found, 'nose') ?? {};
      expect(Math.hypot(x - 0.44, y - 0.25)).toBeLessThan(0.03);
      expect(found.score).toBeGreaterThan(0.2);
      const [nose] = found.keypoints!.elements;
      expect((JSON.parse(nose!.userDataJson) as { score: number }).score).toBeGreaterThan(0.3);
    }
  });

  it('leaves out keypoints below the least score', async () => {
    const all = await detect(photoImage('astronaut.jpg'), { minScore: 0 });
    expect(all.keypoints?.elements).toHaveLength(17);
    const sure = await detect(photoImage('astronaut.jpg'), { minScore: 0.5 });
    expect(sure.keypoints!.elements.length).toBeLessThan(17);
    await module.run(0, { minScore: 0.3 }, ['minScore']);
  });

  it('names its backend, and says why another one is not used', async () => {
    const { backend, error } = await until(({ error }) => error !== undefined, {
      backend: 'webgl',
    });
    expect(backend).toBe('wasm');
    expect(error).toBe(
      'wasm instead of webgl: WebGL in workers needs OffscreenCanvas, which is missing here.',
    );
    const onCpu = await until(({ backend }) => backend === 'cpu', { backend: 'cpu' });
    const { x = 0, y = 0 } = placeOf(onCpu, 'nose') ?? {};
    expect(Math.hypot(x - 0.44, y - 0.25)).toBeLessThan(0.03);
    await until(({ backend }) => backend === 'wasm', { backend: undefined });
  }, 60_000);

  it('smooths from one picture to the next', async () => {
    const away = placeOf(await detect(photoImage('astronaut.jpg'), { smoothingMs: 0 }), 'nose')!;
    const there = placeOf(await detect(photoImage('camera.jpg')), 'nose')!;
    await detect(photoImage('astronaut.jpg'), { smoothingMs: 1000 });
    const between = placeOf(await detect(photoImage('camera.jpg')), 'nose')!;
    // 63 % of the way after one time constant.
    expect((between.y - away.y) / (there.y - away.y)).toBeCloseTo(0.63, 1);
  });

  it('says once what is wrong with an image, and continues with the next', async () => {
    const broken = { width: 10, height: 10, dataFormat: 2, data: new Uint8Array(7) };
    expect((await detect(broken)).error).toMatch(/7 bytes/);
    expect(await detect(broken)).toEqual({});
    expect(await detect(photoImage('camera.jpg'))).toMatchObject({ error: '' });
  });

  it('drops images beyond its rate', async () => {
    await detect(photoImage('camera.jpg'), { maxRate: 2 });
    expect(await module.run(100, {}, ['image'])).toEqual({});
  });
});
