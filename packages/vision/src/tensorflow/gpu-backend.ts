import type { MathBackendWebGL } from '@tensorflow/tfjs-backend-webgl';
import type { WebGPUBackend } from '@tensorflow/tfjs-backend-webgpu';
import * as tf from '@tensorflow/tfjs-core';

import type { BackendName } from './backend-names.ts';

/** Interfaces of a worker to the graphics card. */
export interface GpuSupport {
  /** Why there is none, one sentence; undefined when there is one. */
  readonly absence?: string;
  /** Without a graphics card: a tenth of the speed of wasm, and seconds to compile shaders. */
  readonly isSoftware: boolean;
}

/** Names of renderers that work without a graphics card. */
const SOFTWARE_RENDERERS = /swiftshader|llvmpipe|softpipe|basic render|software/i;

const absent = (absence: string): GpuSupport => ({ absence, isSoftware: false });

/** Looks for WebGL 2 in this worker. */
export function webglSupport(): GpuSupport {
  if (typeof OffscreenCanvas === 'undefined') {
    return absent('WebGL in workers needs OffscreenCanvas, which is missing here.');
  }
  const context = new OffscreenCanvas(1, 1).getContext('webgl2');
  if (context === null) return absent('This browser has no WebGL 2 in workers.');
  const info = context.getExtension('WEBGL_debug_renderer_info');
  const name = String(context.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER));
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return { isSoftware: SOFTWARE_RENDERERS.test(name) };
}

/** Looks for WebGPU in this worker. */
export async function webgpuSupport(): Promise<GpuSupport> {
  const gpu = typeof navigator === 'undefined' ? undefined : (navigator as Partial<Navigator>).gpu;
  if (gpu === undefined) return absent('WebGPU in workers is missing here.');
  const adapter = await gpu.requestAdapter().catch(() => null);
  if (adapter === null) return absent('WebGPU found no graphics card that it can use.');
  const { isFallbackAdapter, vendor, architecture, description } = adapter.info;
  const isSoftware =
    isFallbackAdapter || SOFTWARE_RENDERERS.test(`${vendor} ${architecture} ${description}`);
  // Its first detection takes longer than the 10 s that a call may wait.
  return isSoftware
    ? absent('WebGPU has no graphics card here, and its software renderer is too slow.')
    : { isSoftware };
}

/** The graphics card took away what a backend computes with: a driver was reset, or memory ran out. */
export class BackendLostError extends Error {
  override readonly name = 'BackendLostError';
}

type Factory = NonNullable<ReturnType<typeof tf.findBackendFactory>>;

/** Backend as registered by TensorFlow.js, before it was wrapped. */
const factories = new Map<BackendName, Factory>();
const startErrors = new Map<BackendName, unknown>();

/**
 * Starts a backend and makes it the one in use. One that was lost is started again.
 *
 * @throws the error that kept the backend from starting; TensorFlow.js only writes it to the console
 */
export async function startBackend(name: BackendName): Promise<void> {
  const factory = factories.get(name) ?? tf.findBackendFactory(name);
  const known = tf.engine().registry[name];
  if (factory != null && (known === undefined || lossOf(known) !== undefined)) {
    factories.set(name, factory);
    tf.removeBackend(name);
    tf.registerBackend(name, () => keepError(name, factory));
  }
  startErrors.delete(name);
  if (await tf.setBackend(name)) return;
  const error = startErrors.get(name);
  throw error instanceof Error ? error : new Error(`TensorFlow.js did not start ${name}.`);
}

function keepError(name: BackendName, factory: Factory): ReturnType<Factory> {
  const keep = (error: unknown): never => {
    startErrors.set(name, error);
    throw error;
  };
  try {
    const made = factory();
    return made instanceof Promise ? made.catch(keep) : made;
  } catch (error) {
    return keep(error);
  }
}

/**
 * Runs a task on the backend in use.
 *
 * @throws BackendLostError when the backend is lost before the end, also when the task never ends or seems to succeed
 */
export async function runUnlessLost<Result>(task: () => Promise<Result> | Result): Promise<Result> {
  const watch = watchOf(tf.backend());
  watch.throwIfLost();
  const loss = new Promise<never>((_resolve, reject) => (watch.onLost = reject));
  try {
    const result = await Promise.race([loss, (async () => task())()]);
    watch.throwIfLost();
    return result;
  } catch (error) {
    watch.throwIfLost();
    throw error;
  } finally {
    watch.onLost = undefined;
  }
}

/** Notices that a backend is lost, and rejects the task under way: there is one at a time. */
class LossWatch {
  error: BackendLostError | undefined;
  onLost: ((error: BackendLostError) => void) | undefined;
  readonly #context: WebGL2RenderingContext | undefined;

  constructor(backend: object) {
    if ('gpgpu' in backend) {
      const gl = (backend as MathBackendWebGL).gpgpu.gl as WebGL2RenderingContext;
      this.#context = gl;
      gl.canvas.addEventListener('webglcontextlost', () => this.#check());
    } else if ('device' in backend) {
      void (backend as WebGPUBackend).device.lost.then(({ message }) =>
        this.#lose(`The WebGPU device was lost. ${message}`.trim()),
      );
    }
  }

  throwIfLost(): void {
    // The event comes later than what it is about.
    this.#check();
    if (this.error !== undefined) throw this.error;
  }

  #check(): void {
    const gl = this.#context;
    if (gl?.isContextLost() !== true) return;
    // TensorFlow.js asks forever whether a lost context has finished.
    gl.clientWaitSync = () => gl.ALREADY_SIGNALED;
    this.#lose('The WebGL context was lost.');
  }

  #lose(message: string): void {
    if (this.error !== undefined) return;
    this.error = new BackendLostError(message);
    this.onLost?.(this.error);
  }
}

const watches = new WeakMap<object, LossWatch>();

function watchOf(backend: object): LossWatch {
  let watch = watches.get(backend);
  if (watch === undefined) watches.set(backend, (watch = new LossWatch(backend)));
  return watch;
}

/** Why a backend was lost; undefined when it was not. */
export function lossOf(backend: object): BackendLostError | undefined {
  return watches.get(backend)?.error;
}
