import * as tf from '@tensorflow/tfjs-core';
import { CENTER_NET_MODEL, createCenterNet, createTensorflow, type Tensorflow } from '@ubii/vision';
import { readAssetSet } from '@ubii/vision/assets';
import { readPhoto } from '@ubii/vision/testing';
import type { Callee } from '../calls/call-series.ts';
import { measureCalls, warmUp } from '../calls/measure-calls.ts';
import type { Subject, Workload } from '../measuring/workload.ts';

const REFERENCE = 'TensorFlow.js';

/** 512 × 512 pixels: neither of the two scales it. */
const PHOTO = 'camera.jpg';
const SIZE = 512;

/** Detection of objects in a photograph, beside inference alone by the library of the detector. */
export const detection: Workload = {
  name: 'detection',
  group: 'detection',
  title: `Objects in a photograph of ${SIZE} x ${SIZE} pixels, CenterNet, wasm`,
  figures: [
    {
      key: 'p50Us',
      label: 'p50',
      unit: 'µs',
      isHigherBetter: false,
      goals: { '@ubii/vision': 1.15 },
    },
    { key: 'p99Us', label: 'p99', unit: 'µs', isHigherBetter: false, goals: {} },
  ],
  reference: REFERENCE,
  placement: 'one-core',
  roundShare: 1 / 3,
  open: async () => {
    const tensorflow = await createTensorflow(readAssetSet('tfjs-wasm'), { backend: 'wasm' });
    return [
      await subject(REFERENCE, await bareInference(tensorflow)),
      await subject('@ubii/vision', await wholeDetection(tensorflow)),
    ];
  },
};

/** Runs the model on an input that was made before, and reads its two results back. */
async function bareInference(tensorflow: Tensorflow): Promise<Callee<undefined, number>> {
  const model = await tensorflow.loadModel(readAssetSet('centernet-coco'), CENTER_NET_MODEL);
  const input = tf.tensor4d(Float32Array.from(readPhoto(PHOTO).data), [1, SIZE, SIZE, 3]);
  return {
    sequence: 0,
    prepare: () => undefined,
    call: async () => {
      const results = model.execute(input, ['tower_0/keypoints', 'tower_0/wh']) as tf.Tensor[];
      const [centers] = await Promise.all(results.map((result) => result.data()));
      tf.dispose(results);
      return centers!.length;
    },
    isRight: (count) => count === (SIZE / 4) ** 2 * 80,
  };
}

async function wholeDetection(
  tensorflow: Tensorflow,
): Promise<Callee<undefined, readonly { class: string }[]>> {
  const detector = await createCenterNet(tensorflow, readAssetSet('centernet-coco'));
  const picture = readPhoto(PHOTO);
  return {
    sequence: 0,
    prepare: () => undefined,
    call: () => detector.detect(picture, { inputSize: SIZE }),
    isRight: (found) => found.length === 1 && found[0]!.class === 'person',
  };
}

async function subject<P, A>(name: string, callee: Callee<P, A>): Promise<Subject> {
  await warmUp(callee);
  return { name, pids: [], measure: (options) => measureCalls(callee, options) };
}
