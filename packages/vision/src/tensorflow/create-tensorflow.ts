import '@tensorflow/tfjs-backend-cpu';
import { setWasmPaths } from '@tensorflow/tfjs-backend-wasm';
import '@tensorflow/tfjs-backend-webgl';
import '@tensorflow/tfjs-backend-webgpu';
import { type GraphModel, loadGraphModel } from '@tensorflow/tfjs-converter';
import * as tf from '@tensorflow/tfjs-core';
import {
  type BackendCandidate,
  type BackendChoice,
  type BackendName,
  chooseBackend,
} from './choose-backend.ts';
import { type Files, useMemoryPlatform } from './memory-platform.ts';
import { readModelFiles } from './model-files.ts';
import { knownResults, probeError, runProbe } from './probe.ts';

/** The file of the backend `wasm`: the build with SIMD, for one thread. */
export const WASM_FILE = 'tfjs-backend-wasm-simd.wasm';

export interface TensorflowOptions {
  /** Backend to use when it works; default `auto`, the fastest. */
  readonly backend?: BackendName | 'auto';
  /** Milliseconds of a steady clock; default `performance.now`. */
  readonly now?: () => number;
}

/** TensorFlow.js with a verified backend. All instances in a worker share its memory. */
export interface Tensorflow extends BackendChoice {
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
    const known = knownResults();
    const candidates = [
      // Before software renderers, which are not faster and take seconds to start.
      cpuCandidate(),
      gpuCandidate('webgpu', 'WebGPU'),
      gpuCandidate('webgl', 'WebGL'),
      wasmCandidate(files),
    ].map((candidate) => ({
      ...candidate,
      start: async () => {
        await candidate.start?.();
        if (!(await tf.setBackend(candidate.name))) throw new Error('It could not be started.');
        await tf.ready();
      },
      probe: async () => probeError(await runProbe(), known),
    }));
    const choice = await chooseBackend(candidates, {
      wanted: backend === 'auto' ? undefined : backend,
      now,
    });
    const run: Tensorflow['run'] = (task) =>
      inTurn(async () => {
        if (tf.getBackend() !== choice.backend) await tf.setBackend(choice.backend);
        return task();
      });
    return {
      ...choice,
      run,
      loadModel: async (modelFiles, modelName) => {
        const artifacts = readModelFiles(modelFiles, modelName);
        return run(() => loadGraphModel({ load: () => Promise.resolve(artifacts) }));
      },
    };
  });
}

const shared = new Map<BackendName | 'auto', Promise<Tensorflow>>();

/**
 * The one TensorFlow.js of this worker for a backend, which is made by the first caller: the choice of a
 * backend takes longer than a detection. A failure is not kept.
 */
export function sharedTensorflow(
  files: Files,
  backend: BackendName | 'auto' = 'auto',
): Promise<Tensorflow> {
  const known = shared.get(backend);
  if (known !== undefined) return known;
  const made = createTensorflow(files, { backend }).catch((error: unknown) => {
    shared.delete(backend);
    throw error;
  });
  shared.set(backend, made);
  return made;
}

type Candidate = Pick<BackendCandidate, 'name' | 'absence' | 'isLastResort'> & {
  start?: () => Promise<void>;
};

/** Backends for graphics cards register themselves when the browser supports them. */
function gpuCandidate(name: 'webgl' | 'webgpu', label: string): Candidate {
  return {
    name,
    absence: tf.findBackendFactory(name) == null ? `${label} is missing here.` : undefined,
    // A software renderer has a tenth of the speed of wasm and compiles its shaders for seconds.
    isLastResort: isSoftwareRenderer(),
  };
}

/** Names of renderers that work without a graphics card. */
const SOFTWARE_RENDERERS = /swiftshader|llvmpipe|softpipe|basic render|software/i;

function isSoftwareRenderer(): boolean {
  if (typeof OffscreenCanvas === 'undefined') return false;
  const context = new OffscreenCanvas(1, 1).getContext('webgl2');
  const info = context?.getExtension('WEBGL_debug_renderer_info');
  if (context == null || info == null) return false;
  const name = String(context.getParameter(info.UNMASKED_RENDERER_WEBGL));
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return SOFTWARE_RENDERERS.test(name);
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
      // Reads through the memory platform, which ignores the path before the file name.
      setWasmPaths('memory/', true);
    },
  };
}

function cpuCandidate(): Candidate {
  return { name: 'cpu', isLastResort: true };
}
