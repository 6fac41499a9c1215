import '@tensorflow/tfjs-backend-cpu';
import { setWasmPaths } from '@tensorflow/tfjs-backend-wasm';
import '@tensorflow/tfjs-backend-webgl';
import '@tensorflow/tfjs-backend-webgpu';
import { type GraphModel, loadGraphModel } from '@tensorflow/tfjs-converter';
import * as tf from '@tensorflow/tfjs-core';
import type { BackendName } from './backend-names.ts';
import { type BackendCandidate, type BackendChoice, chooseBackend } from './choose-backend.ts';
import {
  BackendLostError,
  lossOf,
  runUnlessLost,
  startBackend,
  webglSupport,
  webgpuSupport,
  type GpuSupport,
} from './gpu-backend.ts';
import { type Files, useMemoryPlatform } from './memory-platform.ts';
import { readModelFiles } from './model-files.ts';
import { knownResults, probeError, runProbe } from './probe.ts';

/** The file of the backend `wasm`: the build with SIMD, for one thread. */
export const WASM_FILE = 'tfjs-backend-wasm-simd.wasm';

/** A backend by name, the fastest, or the one that starts first. */
export type WantedBackend = BackendName | 'auto' | 'soonest';

export interface TensorflowOptions {
  /** Backend to use when it works; `soonest`: the one that starts first; default `auto`, the fastest. */
  readonly backend?: WantedBackend;
  /** Milliseconds of a steady clock; default `performance.now`. */
  readonly now?: () => number;
}

/** TensorFlow.js with a verified backend. All instances in a worker share its memory. */
export interface Tensorflow extends BackendChoice {
  /** The backend of TensorFlow.js itself: models on the same one share its memory. */
  readonly instance: object;
  /**
   * Loads a graph model.
   *
   * @param files with the model's `.json` and the weights it names
   * @param modelName name of the `.json`
   * @throws Error that names the file that is missing or damaged
   */
  loadModel(files: Files, modelName: string): Promise<GraphModel>;
  /**
   * Runs a task on this backend. Tasks of one worker run one after the other: the backend in use is
   * a single variable of TensorFlow.js.
   *
   * @throws BackendLostError when the graphics card takes the backend away before the end
   */
  run<Result>(task: () => Promise<Result> | Result): Promise<Result>;
}

/** End of the last task in this worker. TensorFlow.js has one backend at a time. */
let lastTask: Promise<unknown> = Promise.resolve();

function inTurn<Result>(task: () => Promise<Result> | Result): Promise<Result> {
  const turn = lastTask.then(task);
  lastTask = turn.catch(() => undefined);
  return turn;
}

/**
 * Starts TensorFlow.js: tries the available backends and selects the fastest one with correct results.
 * Has no network access.
 *
 * @param files with `WASM_FILE`, for the backend `wasm`
 * @throws Error when no backend works
 */
export function createTensorflow(
  files: Files,
  { backend = 'auto', now = () => performance.now() }: TensorflowOptions = {},
): Promise<Tensorflow> {
  return inTurn(async () => {
    useMemoryPlatform(files);
    // Suppresses the advice to install other packages, which is written to the console.
    tf.env().set('PROD', true);
    // Software renderers are a last resort here (`isLastResort`), and not refused by TensorFlow.js.
    if (typeof OffscreenCanvas !== 'undefined') tf.env().set('SOFTWARE_WEBGL_ENABLED', true);
    const known = knownResults();
    const candidates = [
      // Before software renderers, which are not faster and take seconds to start.
      cpuCandidate(),
      gpuCandidate('webgpu', await webgpuSupport()),
      gpuCandidate('webgl', webglSupport()),
      wasmCandidate(files),
    ].map((candidate) => ({
      ...candidate,
      start: async () => {
        await candidate.start?.();
        await startBackend(candidate.name);
      },
      probe: async () => probeError(await runUnlessLost(runProbe), known),
    }));
    const choice = await chooseBackend(candidates, {
      wanted: backend === 'auto' ? undefined : backend === 'soonest' ? 'wasm' : backend,
      isProvisional: backend === 'soonest',
      now,
    });
    // Models live in the memory of this one: another one of the same name does not have them.
    const instance = tf.engine().registry[choice.backend]!;
    const run: Tensorflow['run'] = (task) =>
      inTurn(async () => {
        if (tf.engine().registry[choice.backend] !== instance) {
          throw lossOf(instance) ?? new BackendLostError(`${choice.backend} was started again.`);
        }
        if (tf.getBackend() !== choice.backend) await tf.setBackend(choice.backend);
        return runUnlessLost(task);
      });
    return {
      ...choice,
      instance,
      run,
      loadModel: async (modelFiles, modelName) => {
        const artifacts = readModelFiles(modelFiles, modelName);
        return run(() => loadGraphModel({ load: () => Promise.resolve(artifacts) }));
      },
    };
  });
}

const shared = new Map<WantedBackend, Promise<Tensorflow>>();

/**
 * The one TensorFlow.js of this worker for a backend, which is made by the first caller: the choice of a
 * backend takes longer than a detection. A failure is not kept, nor a backend that was lost.
 */
export function sharedTensorflow(
  files: Files,
  backend: WantedBackend = 'auto',
): Promise<Tensorflow> {
  const known = shared.get(backend);
  const made = known === undefined ? start() : known.then((one) => (isLost(one) ? start() : one));
  shared.set(backend, made);
  return made;

  function start(): Promise<Tensorflow> {
    const started = createTensorflow(files, { backend });
    started.catch(() => shared.delete(backend));
    return started;
  }
}

function isLost({ backend, instance }: Tensorflow): boolean {
  return tf.engine().registry[backend] !== instance || lossOf(instance) !== undefined;
}

type Candidate = Pick<BackendCandidate, 'name' | 'absence' | 'isLastResort'> & {
  start?: () => Promise<void>;
};

/** Backends for graphics cards register themselves when the browser supports them. */
function gpuCandidate(name: 'webgl' | 'webgpu', support: GpuSupport): Candidate {
  const absence =
    support.absence ??
    (tf.findBackendFactory(name) == null ? `TensorFlow.js does not know ${name} here.` : undefined);
  return { name, absence, isLastResort: support.isSoftware };
}

function wasmCandidate(files: Files): Candidate {
  const bytes = files[WASM_FILE];
  return {
    name: 'wasm',
    absence:
      bytes === undefined
        ? `The file "${WASM_FILE}" was not passed to createTensorflow.`
        : undefined,
    start: async () => {
      // The backend neither resolves nor rejects for a damaged file, so the file is checked first.
      if (!WebAssembly.validate(bytes!.slice())) {
        throw new Error(`The file "${WASM_FILE}" is damaged, or WebAssembly SIMD is missing here.`);
      }
      // The build for threads starts workers from source text, which the policies of workers forbid.
      tf.env().set('WASM_HAS_MULTITHREAD_SUPPORT', false);
      // Reads through the memory platform, which ignores the path before the filename.
      setWasmPaths('memory/', true);
    },
  };
}

function cpuCandidate(): Candidate {
  return { name: 'cpu', isLastResort: true };
}
