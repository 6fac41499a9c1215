import type { Picture } from '../picture.ts';
import type { BackendName } from '../tensorflow/choose-backend.ts';
import { sharedTensorflow, type Tensorflow } from '../tensorflow/create-tensorflow.ts';
import type { Files } from '../tensorflow/memory-platform.ts';
import { createCenterNet } from './center-net.ts';
import { createCocoSsd } from './coco-ssd.ts';
import type { Detection, DetectionOptions, Detector } from './detector.ts';

/** Detectors by the names that modules use. */
const DETECTORS = {
  centernet: { title: 'CenterNet', create: createCenterNet },
  'coco-ssd': { title: 'COCO-SSD', create: createCocoSsd },
} as const;
const BACKENDS = ['auto', 'webgpu', 'webgl', 'wasm', 'cpu'] as const;
/** What is used in place of a backend that fails while it detects. */
const NEXT_BACKEND: Readonly<Record<BackendName, BackendName | undefined>> = {
  webgpu: 'wasm',
  webgl: 'wasm',
  wasm: 'cpu',
  cpu: undefined,
};
/** How often the files of a detector that are missing are asked for again, milliseconds. */
const RETRY_MS = 5_000;

export type DetectorName = keyof typeof DETECTORS;

/** What a choice of detectors needs. */
export interface DetectorSources {
  /** For `createTensorflow`. */
  readonly tensorflow: Files;
  readonly centerNet: Files;
  /** Loads the files of COCO-SSD. Rejects with an error whose `code` is `missing` when they are not installed. */
  loadCocoSsd(): Promise<Files>;
  /** Told of each detector and backend in use, one sentence. */
  onChange?(text: string): void;
  /** Milliseconds of a steady clock; default `performance.now`. */
  now?(): number;
  /** Default: the TensorFlow.js that the worker shares. */
  createTensorflow?(files: Files, backend: BackendName | 'auto'): Promise<Tensorflow>;
}

interface Wish {
  readonly detector: DetectorName;
  readonly backend: BackendName | 'auto';
  /** Why it is not what the caller asked for; empty when it is. */
  readonly problem: string;
}

interface Loaded {
  readonly name: DetectorName;
  readonly detector: Detector;
  readonly tensorflow: Tensorflow;
}

/**
 * One detector and one backend out of several, which can be changed while it detects: the detector in use
 * goes on until the next one is loaded. What cannot be had is replaced, and `problem` says why.
 */
export class DetectorChoice {
  readonly #sources: DetectorSources;
  #inUse: Loaded;
  /** What the caller asked for last. */
  #asked = 'centernet auto';
  #wish: Wish = { detector: 'centernet', backend: 'auto', problem: '' };
  #problem = '';
  #following: Promise<void> | undefined;
  #retryAtMs = Infinity;
  #isDisposed = false;

  /**
   * Starts with CenterNet on the fastest backend.
   * @throws Error when no backend works, or its files are damaged
   */
  static async create(sources: DetectorSources): Promise<DetectorChoice> {
    const tensorflow = await tensorflowOf(sources, 'auto');
    const detector = await createCenterNet(tensorflow, sources.centerNet);
    return new DetectorChoice(sources, { name: 'centernet', detector, tensorflow });
  }

  private constructor(sources: DetectorSources, inUse: Loaded) {
    this.#sources = sources;
    this.#inUse = inUse;
    this.#tell();
  }

  get detector(): DetectorName {
    return this.#inUse.name;
  }

  get backend(): BackendName {
    return this.#inUse.tensorflow.backend;
  }

  /** Threshold of the detector in use where the caller names none. */
  get defaultThreshold(): number {
    return this.#inUse.detector.defaultThreshold;
  }

  /** Which backends failed when the one in use was chosen, and what replaces them; empty when none did. */
  get backendFault(): string {
    const { trials, backend } = this.#inUse.tensorflow;
    return trials
      .filter(({ outcome }) => outcome === 'failed' || outcome === 'wrong')
      .map(({ name, reason }) => `${name} does not work: ${reason} ${backend} replaces it.`)
      .join(' ');
  }

  /** Why detector or backend are not those that were chosen, for people; empty when they are. */
  get problem(): string {
    return this.#problem;
  }

  /**
   * Chooses detector and backend, which are loaded meanwhile. The same choice again does nothing, except to
   * look again for files that were missing.
   *
   * @param detector `centernet` or `coco-ssd`
   * @param backend `auto`, `webgpu`, `webgl`, `wasm` or `cpu`
   */
  choose(detector: string, backend: string): void {
    const asked = `${detector} ${backend}`;
    if (asked !== this.#asked) {
      this.#asked = asked;
      this.#wish = readWish(detector, backend, this.#inUse.name);
    } else if (this.#now() < this.#retryAtMs) return;
    this.#retryAtMs = Infinity;
    void this.#follow();
  }

  /** Detects with what is in use now. See `Detector.detect`. */
  async detect(picture: Picture, options?: DetectionOptions): Promise<Detection[]> {
    const { detector, tensorflow } = this.#inUse;
    try {
      return await detector.detect(picture, options);
    } catch (error) {
      const next = NEXT_BACKEND[tensorflow.backend];
      // A picture or a class is wrong; or nothing is left to be tried.
      if (error instanceof RangeError || next === undefined || this.#isDisposed) throw error;
      const problem = `The backend ${tensorflow.backend} failed: ${messageOf(error)} ${next} is used instead.`;
      this.#wish = { ...this.#wish, backend: next, problem };
      await this.#follow();
      return this.#inUse.detector.detect(picture, options);
    }
  }

  /** Resolves when nothing is being loaded. */
  async settled(): Promise<void> {
    await this.#following;
  }

  dispose(): void {
    this.#isDisposed = true;
    this.#inUse.detector.dispose();
  }

  /** Loads one after the other what is wished, until that is in use. */
  #follow(): Promise<void> {
    this.#following ??= (async () => {
      for (let wish: Wish | undefined; wish !== this.#wish;) {
        wish = this.#wish;
        const problems = await this.#apply(wish);
        this.#problem = [wish.problem, ...problems].filter(Boolean).join(' ');
      }
    })().finally(() => (this.#following = undefined));
    return this.#following;
  }

  /** @returns what did not work */
  async #apply({ detector, backend }: Wish): Promise<string[]> {
    const problems: string[] = [];
    let tensorflow: Tensorflow;
    try {
      tensorflow = await tensorflowOf(this.#sources, backend);
    } catch (error) {
      return [messageOf(error)];
    }
    if (backend !== 'auto' && tensorflow.backend !== backend) problems.push(tensorflow.reason);
    try {
      await this.#use(detector, tensorflow);
    } catch (error) {
      problems.push(this.#whyNot(detector, error));
      // On the chosen backend all the same.
      await this.#use('centernet', tensorflow).catch((other: unknown) =>
        problems.push(messageOf(other)),
      );
    }
    return problems;
  }

  async #use(name: DetectorName, tensorflow: Tensorflow): Promise<void> {
    const before = this.#inUse;
    if (before.name === name && before.tensorflow.backend === tensorflow.backend) return;
    const files =
      name === 'centernet' ? this.#sources.centerNet : await this.#sources.loadCocoSsd();
    const detector = await DETECTORS[name].create(tensorflow, files);
    if (this.#isDisposed) return detector.dispose();
    this.#inUse = { name, detector, tensorflow };
    this.#tell();
    // After a detection under way. A backend that is lost took the memory of its models along.
    await before.tensorflow.run(() => before.detector.dispose()).catch(() => undefined);
  }

  #whyNot(name: DetectorName, error: unknown): string {
    const { title } = DETECTORS[name];
    const isMissing = (error as { code?: unknown } | null)?.code === 'missing';
    if (!isMissing)
      return `${title} cannot be used: ${messageOf(error)} CenterNet detects instead.`;
    this.#retryAtMs = this.#now() + RETRY_MS;
    return `The model of ${title} is not installed. Get it on the page of this module, or with "npm run models -- get ${name}" on the machine of the master. Until then, CenterNet detects.`;
  }

  #tell(): void {
    const { name, tensorflow } = this.#inUse;
    this.#sources.onChange?.(
      `${DETECTORS[name].title} uses ${tensorflow.backend}. ${tensorflow.reason}`,
    );
  }

  #now(): number {
    return this.#sources.now?.() ?? performance.now();
  }
}

function tensorflowOf(
  { tensorflow, createTensorflow = sharedTensorflow }: DetectorSources,
  backend: BackendName | 'auto',
): Promise<Tensorflow> {
  return createTensorflow(tensorflow, backend);
}

/** Names that are unknown are a problem, and leave things as they are. */
function readWish(detector: string, backend: string, inUse: DetectorName): Wish {
  const problems: string[] = [];
  const isDetector = Object.hasOwn(DETECTORS, detector);
  if (!isDetector) {
    const names = Object.keys(DETECTORS).join(' and ');
    problems.push(
      `There is no detector "${detector}". There are ${names}. ${DETECTORS[inUse].title} detects.`,
    );
  }
  const isBackend = (BACKENDS as readonly string[]).includes(backend);
  if (!isBackend) {
    problems.push(`There is no backend "${backend}". There are ${BACKENDS.join(', ')}.`);
  }
  return {
    detector: isDetector ? (detector as DetectorName) : inUse,
    backend: isBackend ? (backend as Wish['backend']) : 'auto',
    problem: problems.join(' '),
  };
}

function messageOf(error: unknown): string {
  const text = error instanceof Error ? error.message : String(error);
  return text.endsWith('.') ? text : `${text}.`;
}
