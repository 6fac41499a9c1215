/**
 * Times of detection on the photographs of the tests, in one thread of Node: `pnpm build`, then
 * `pnpm measure`. The shortest of ten runs after two, as other programs only add to a time.
 */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { decode } from 'jpeg-js';
import { readAssetSet } from './asset-sets.mjs';

const inPackage = (...path) => join(import.meta.dirname, '..', ...path);
const RUNS = 10;
const WARM_UPS = 2;

// As workers of modules do it
const vision = (0, eval)(readFileSync(inPackage('dist', 'vision.js'), 'utf8'));
const tensorflow = await vision.createTensorflow(readAssetSet('tfjs-wasm'));
console.log(tensorflow.reason, JSON.stringify(tensorflow.trials[0]));

const pictures = readdirSync(inPackage('photos'))
  .filter((file) => file.endsWith('.jpg'))
  .map((file) => {
    const bytes = readFileSync(inPackage('photos', file));
    const { width, height, data } = decode(bytes, { useTArray: true });
    return { width, height, format: 'RGBA8', data };
  });

/** @param {string} what @param {(picture: object) => unknown} run */
async function measure(what, run) {
  const times = [];
  for (let index = 0; index < WARM_UPS + RUNS; index++) {
    const startedAt = performance.now();
    await run(pictures[index % pictures.length]);
    times.push(performance.now() - startedAt);
  }
  console.log(`${what}: ${Math.min(...times.slice(WARM_UPS)).toFixed(1)} ms`);
}

const centerNet = await vision.createCenterNet(tensorflow, readAssetSet('centernet-coco'));
for (const inputSize of [512, 384, 256]) {
  await measure(`CenterNet at ${inputSize} pixels`, (picture) =>
    centerNet.detect(picture, { inputSize }),
  );
}
const bodyPose = await vision.createBodyPose(tensorflow, readAssetSet('movenet-lightning'));
await measure('MoveNet Lightning', (picture) => bodyPose.detect(picture));
const handPose = await vision.createHandPose(tensorflow, readAssetSet('hand-pose'));
await measure('hand pose, no hand', (picture) => handPose.detect(picture));
for (const [width, height] of [
  [640, 480],
  [4032, 3024],
]) {
  const pixels = vision.scalePicture(pictures[0], width, height);
  await measure(`scale ${width} × ${height} to 384 × 288`, () =>
    vision.scalePicture(pixels, 384, 288),
  );
}
