import { readAssetSet } from '../scripts/asset-sets.mjs';
import { OpenCvRuntime } from '../src/opencv/open-cv-runtime.ts';
import type { OpenCvFactory } from '../src/opencv/open-cv.ts';

/** OpenCV out of its asset set, as workers evaluate it. */
export function createOpenCvRuntime(): OpenCvRuntime {
  const files = readAssetSet('opencv');
  const script = new TextDecoder().decode(files['opencv.js']);
  // eslint-disable-next-line no-eval -- as workers of trusted modules do
  return new OpenCvRuntime((0, eval)(script) as OpenCvFactory, files);
}
