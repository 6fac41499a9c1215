import { ModelChoice } from '../model-choice.ts';
import type { ModelSources } from '../model-sources.ts';
import type { Picture } from '../picture.ts';
import type { BackendName } from '../tensorflow/backend-names.ts';
import type { Files } from '../tensorflow/memory-platform.ts';
import { createCenterNet } from './center-net.ts';
import { createCocoSsd } from './coco-ssd.ts';
import type { DetectorName } from './detector-names.ts';
import type { Detection, DetectionOptions, Detector } from './detector.ts';

/** Dependencies of a choice of detectors. */
export interface DetectorSources extends Omit<ModelSources<DetectorName, Detector>, 'models'> {
  readonly centerNet: Files;
  /** Loads the files of COCO-SSD. Rejects with an error whose `code` is `missing` when they are not installed. */
  loadCocoSsd(): Promise<Files>;
}

/** CenterNet or COCO-SSD on one of several backends, both changed while it detects. See `ModelChoice`. */
export class DetectorChoice {
  readonly #choice: ModelChoice<DetectorName, Detector>;

  /**
   * Starts with CenterNet on the backend that starts soonest.
   * @throws Error when no backend works, or its files are damaged
   */
  static async create({
    centerNet,
    loadCocoSsd,
    ...sources
  }: DetectorSources): Promise<DetectorChoice> {
    const choice = await ModelChoice.create<DetectorName, Detector>({
      ...sources,
      models: {
        centernet: { title: 'CenterNet', load: () => centerNet, create: createCenterNet },
        'coco-ssd': { title: 'COCO-SSD', load: loadCocoSsd, create: createCocoSsd },
      },
    });
    return new DetectorChoice(choice);
  }

  private constructor(choice: ModelChoice<DetectorName, Detector>) {
    this.#choice = choice;
  }

  get detector(): DetectorName {
    return this.#choice.name;
  }

  get backend(): BackendName {
    return this.#choice.backend;
  }

  /** Threshold of the detector in use where the caller names none. */
  get defaultThreshold(): number {
    return this.#choice.model.defaultThreshold;
  }

  get backendFault(): string {
    return this.#choice.backendFault;
  }

  get problem(): string {
    return this.#choice.problem;
  }

  choose(detector: string, backend: string): void {
    this.#choice.choose(detector, backend);
  }

  /** Detects with what is in use now. See `Detector.detect`. */
  detect(picture: Picture, options?: DetectionOptions): Promise<Detection[]> {
    return this.#choice.use((detector) => detector.detect(picture, options));
  }

  /** Resolves when nothing is being loaded. */
  settled(): Promise<void> {
    return this.#choice.settled();
  }

  dispose(): void {
    this.#choice.dispose();
  }
}
