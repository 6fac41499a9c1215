import { moduleLibrary } from '@ubii/modules';
import {
  createAssetStore,
  createHttpAssets,
  DEFAULT_RUNTIME_LIMITS,
  parseModule,
  type SandboxFactory,
  type SandboxInput,
} from '@ubii/pm-sandbox';
import { decodeRecord, encodeRecord, Image2DDataFormat, type Object2DList } from '@ubii/proto';
import type { Sighting } from './accuracy.ts';
import type { Detect, Pixels } from './detect.ts';
import type { DetectionBackend } from './library-messages.ts';

/** Software renderers compile their programs for seconds. */
const CALL_TIMEOUT_MS = 60_000;
/** Software renderers compile the programs of a model for so long. */
const LONGEST_START_MS = 120_000;
const MODULE = 'object-detection';
/** Side of the photograph: both sides scale nothing. */
const INPUT_SIZE = 512;
/** Longer than the module waits between two images. */
const DELTA_TIME_MS = 10_000;

/** The module of the library in a trusted worker, as a node in a page runs it. */
export async function openDetector(
  sandboxes: SandboxFactory,
  backend: DetectionBackend,
): Promise<Detect> {
  const message = moduleLibrary().find(({ name }) => name === MODULE)!;
  const { name, source, inputs, outputs, assets: sets, libraries } = parseModule(message);
  const store = createAssetStore(createHttpAssets(location.origin));
  const { memoryBytes, outputBytes } = DEFAULT_RUNTIME_LIMITS;
  const sandbox = sandboxes.open(
    {
      instanceId: `${name} ${backend}`,
      moduleName: name,
      source: source!,
      isTrusted: true,
      libraries,
      assets: await store.load(sets, new AbortController().signal, () => undefined),
      owner: '',
      inputs: inputs.map((input) => input.name),
      outputs,
      limits: { callTimeoutMs: CALL_TIMEOUT_MS, memoryBytes, outputBytes },
    },
    { onLog: () => undefined, onKilled: () => undefined },
  );
  await sandbox.create().catch(toError);
  const parameters: SandboxInput[] = [
    input('inputSize', encodeRecord({ topic: '/size', format: 'double', value: INPUT_SIZE })),
    input('backend', encodeRecord({ topic: '/backend', format: 'string', value: backend })),
  ];
  /** The module's outputs for a picture. */
  const run = async ({ width, height, rgba }: Pixels): Promise<ReadonlyMap<string, unknown>> => {
    const data = new Uint8Array(rgba.buffer);
    const value = { width, height, dataFormat: Image2DDataFormat.RGBA8, data };
    const image = input('image', encodeRecord({ topic: '/image', format: 'image2D', value }));
    const { outputs: given, faults } = await sandbox
      .run({ deltaTimeMs: DELTA_TIME_MS, inputs: [image, ...parameters], triggers: ['image'] })
      .catch(toError);
    if (faults.length > 0) throw new Error(JSON.stringify(faults[0]));
    return new Map(
      given.flatMap((output) =>
        'value' in output ? [[output.name, decodeRecord(output.value.bytes).value] as const] : [],
      ),
    );
  };
  let isReady = false;
  return async (picture) => {
    let results = await run(isReady ? picture : copyOf(picture));
    // It detects with another backend until the one that was asked for is ready.
    for (const endMs = performance.now() + LONGEST_START_MS; results.get('backend') !== backend;) {
      if (results.get('error') || performance.now() > endMs)
        throw new Error(
          String(results.get('error') || `It computes with ${results.get('backend')}.`),
        );
      results = await run(copyOf(picture));
    }
    isReady = true;
    return sightings(results.get('predictions') as Object2DList);
  };
}

/** Faults of modules are values; Playwright says of these only that they are objects. */
function toError(fault: unknown): never {
  throw new Error(JSON.stringify(fault));
}

/** The module takes the pixels of what it is given away. */
const copyOf = (picture: Pixels): Pixels => ({ ...picture, rgba: picture.rgba.slice() });

function input(name: string, bytes: Uint8Array): SandboxInput {
  return { name, record: { bytes, isOwned: name === 'image' } };
}

function sightings({ elements }: Object2DList): Sighting[] {
  return elements.map(({ id, pose, size }) => ({
    class: id,
    box: {
      x: pose?.position?.x ?? 0,
      y: pose?.position?.y ?? 0,
      width: size?.x ?? 0,
      height: size?.y ?? 0,
    },
  }));
}
