/** Script of a worker: `@vladmandic/human` as its documentation uses it, for objects alone. */
import Human from '@vladmandic/human';
import type { DetectionBackend, LibraryAnswer, LibraryCall } from './library-messages.ts';

/** As the module's parameters are in this benchmark. */
const OBJECT = { minConfidence: 0.4, iouThreshold: 0.5, maxDetected: 20 };
const OFF = { enabled: false };

async function start(backend: DetectionBackend): Promise<Human> {
  const human = new Human({
    backend,
    wasmPath: '/human/',
    modelBasePath: '/human/',
    // Its first run would be on a picture of its own.
    warmup: 'none',
    cacheSensitivity: 0,
    filter: OFF,
    gesture: OFF,
    face: OFF,
    body: OFF,
    hand: OFF,
    object: { enabled: true, modelPath: 'centernet.json', skipFrames: 0, skipTime: 0, ...OBJECT },
  });
  await human.load();
  return human;
}

let human: Promise<Human> | undefined;

globalThis.onmessage = async ({ data }: MessageEvent<LibraryCall>) => {
  const { backend, width, height, rgba } = data;
  let answer: LibraryAnswer;
  try {
    const { detect, tf } = await (human ??= start(backend));
    const result = await detect.call(await human, new ImageData(rgba, width, height));
    if (result.error) throw new Error(result.error);
    if (tf.getBackend() !== backend) throw new Error(`It computes with ${tf.getBackend()}.`);
    answer = {
      seen: result.object.map(({ label, boxRaw: [x, y, width, height] }) => ({
        class: label,
        box: { x, y, width, height },
      })),
    };
  } catch (thrown) {
    answer = { error: thrown instanceof Error ? thrown.message : String(thrown) };
  }
  globalThis.postMessage(answer);
};
