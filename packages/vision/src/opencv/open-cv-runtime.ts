import type { Files } from '../tensorflow/memory-platform.ts';
import type { CvObject, OpenCv, OpenCvFactory } from './open-cv.ts';

/** The WebAssembly in the asset set `opencv`. */
export const OPENCV_WASM_FILE = 'opencv.wasm';

/** Takes an object into the task: it is deleted when the task ends. */
export type Keep = <T extends CvObject>(object: T) => T;

/** OpenCV refused its arguments, or stopped. */
export class OpenCvError extends Error {
  override readonly name = 'OpenCvError';
}

/** One OpenCV: its memory, and how its failures become errors. */
export class OpenCvRuntime {
  readonly #factory: OpenCvFactory;
  readonly #wasm: Uint8Array;
  #loading: Promise<{ cv: OpenCv }> | undefined;
  #cv: OpenCv | undefined;

  /** @throws Error when the set is incomplete */
  constructor(factory: OpenCvFactory, files: Files) {
    const wasm = files[OPENCV_WASM_FILE];
    if (wasm === undefined) throw new Error(`The file "${OPENCV_WASM_FILE}" is missing.`);
    this.#factory = factory;
    this.#wasm = wasm;
  }

  /**
   * Runs a task with OpenCV, which is loaded first where necessary. All that it keeps is deleted afterwards.
   * An OpenCV that stopped is not used again: the next task gets another one, with a memory of its own.
   *
   * @throws OpenCvError for what OpenCV throws; errors of the task as they are
   */
  async run<Result>(task: (cv: OpenCv, keep: Keep) => Result): Promise<Result> {
    this.#loading ??= this.#load();
    const loading = this.#loading;
    let cv: OpenCv;
    try {
      ({ cv } = await loading);
    } catch (error) {
      if (this.#loading === loading) this.#loading = undefined;
      throw error;
    }
    this.#cv = cv;
    const kept: CvObject[] = [];
    try {
      return task(cv, (object) => {
        kept.push(object);
        return object;
      });
    } catch (thrown) {
      const { error, isOver } = describeFailure(cv, thrown);
      if (isOver) {
        if (this.#loading === loading) this.#loading = this.#cv = undefined;
        // Of a memory that may be damaged, nothing can be deleted
        kept.length = 0;
      }
      throw error;
    } finally {
      for (const object of kept.reverse()) object.delete();
    }
  }

  /** Whether this is the OpenCV in use, and not one that stopped. */
  owns(cv: OpenCv): boolean {
    return this.#cv === cv;
  }

  /** In an object, as the library has a `then` until it is ready, which a promise would call. */
  #load(): Promise<{ cv: OpenCv }> {
    return new Promise((resolve, reject) => {
      const fail = (reason: unknown): void => {
        const text = reason instanceof Error ? reason.message : String(reason);
        reject(new OpenCvError(`OpenCV cannot start: ${text}.`));
      };
      const cv = this.#factory({
        // Emscripten's own way would leave an unhandled rejection behind
        instantiateWasm: (imports, receive) => {
          const source = WebAssembly.instantiate(this.#wasm.slice(), imports);
          source.then(({ instance }) => receive(instance)).catch(fail);
          return {};
        },
        onAbort: fail,
        onRuntimeInitialized: () => {
          delete cv.then;
          resolve({ cv });
        },
        print: () => undefined,
        printErr: () => undefined,
      });
    });
  }
}

const shared = new WeakMap<OpenCvFactory, OpenCvRuntime>();

/** The one OpenCV of this worker: each has at least 128 MiB. It is gone with its asset set. */
export function sharedOpenCv(factory: OpenCvFactory, files: Files): OpenCvRuntime {
  let runtime = shared.get(factory);
  if (runtime === undefined) {
    runtime = new OpenCvRuntime(factory, files);
    shared.set(factory, runtime);
  }
  return runtime;
}

/** @returns whether OpenCV cannot be used any more: its memory may be damaged */
function describeFailure(cv: OpenCv, thrown: unknown): { error: unknown; isOver: boolean } {
  if (typeof thrown === 'number') {
    const { msg } = cv.exceptionFromPtr(thrown);
    // "OpenCV(4.12.0) /home/…/file.cpp:134: error: (-2:…) what in function 'name'"
    const text = /error: (.*)/s.exec(msg)?.[1] ?? msg;
    return { error: new OpenCvError(`OpenCV refused this: ${text.trim()}`), isOver: false };
  }
  if (thrown instanceof WebAssembly.RuntimeError || typeof thrown === 'string') {
    const text = typeof thrown === 'string' ? thrown : thrown.message;
    const error = new OpenCvError(`OpenCV stopped (${text}). It is loaded again.`);
    return { error, isOver: true };
  }
  return { error: thrown, isOver: false };
}
