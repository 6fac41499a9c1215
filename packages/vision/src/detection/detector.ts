import type { Picture } from '../picture.ts';

/** A part of a picture: 0 to 1 from left to right and from top to bottom, x and y of the top left corner. */
export interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Something that was found in a picture. */
export interface Detection {
  /** One of the detector's `classNames`. */
  readonly class: string;
  /** Confidence, 0 to 1. Not comparable between detectors. */
  readonly score: number;
  /** Inside of the picture. */
  readonly box: Box;
}

export interface DetectionOptions {
  /** Least score, 0 to 1; default: that of the detector. */
  readonly threshold?: number | undefined;
  /** Most detections, the ones with the highest scores, 1 to 100; default 20. */
  readonly maxObjects?: number | undefined;
  /** Only these classes; default, and when empty: all. */
  readonly classes?: readonly string[];
  /** Pixels of the longer side of what the model sees; default and limits: those of the detector. */
  readonly inputSize?: number | undefined;
}

/** Finds objects in pictures. */
export interface Detector {
  readonly name: string;
  /** All classes that it can detect. */
  readonly classNames: readonly string[];
  /** Least score where the caller names none, 0 to 1. */
  readonly defaultThreshold: number;
  /**
   * Returns the objects in a picture, the highest score first.
   *
   * @throws RangeError when the picture is invalid or a class is unknown to the detector
   */
  detect(picture: Picture, options?: DetectionOptions): Promise<Detection[]>;
  /** Frees the memory of the model. */
  dispose(): void;
}

/** Defaults and limits of a detector. */
export interface DetectionDefaults {
  readonly threshold: number;
  readonly inputSize: { readonly least: number; readonly most: number; readonly usual: number };
}

export type ResolvedOptions = Required<Omit<DetectionOptions, 'classes'>> & {
  /** Indices of the classes; undefined for all. */
  readonly classIndices: ReadonlySet<number> | undefined;
};

/** The evaluation of COCO counts at most 100 detections per picture. */
const MAX_OBJECTS = 100;
/** The default of `@tensorflow-models/coco-ssd`. */
const USUAL_OBJECTS = 20;

/**
 * Resolves options. Numbers out of range become the nearest one in range; missing and non-finite numbers
 * become the default.
 *
 * @throws RangeError for a class that the detector does not know
 */
export function resolveOptions(
  options: DetectionOptions,
  classNames: readonly string[],
  { threshold, inputSize }: DetectionDefaults,
): ResolvedOptions {
  const unknown = options.classes?.filter((name) => !classNames.includes(name)) ?? [];
  if (unknown.length > 0) {
    throw new RangeError(
      `The detector does not know the class "${unknown[0]}". It knows: ${classNames.join(', ')}.`,
    );
  }
  const isFiltered = options.classes !== undefined && options.classes.length > 0;
  return {
    threshold: clamp(options.threshold, 0, 1, threshold),
    maxObjects: Math.round(clamp(options.maxObjects, 1, MAX_OBJECTS, USUAL_OBJECTS)),
    inputSize: clamp(options.inputSize, inputSize.least, inputSize.most, inputSize.usual),
    classIndices: isFiltered
      ? new Set(options.classes.map((name) => classNames.indexOf(name)))
      : undefined,
  };
}

function clamp(value: number | undefined, least: number, most: number, fallback: number): number {
  return Math.min(most, Math.max(least, Number.isFinite(value) ? value! : fallback));
}
