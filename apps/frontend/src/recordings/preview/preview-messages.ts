import type { DataFormatFamily } from '@ubii/proto';
import type { ReadableFile } from '../files/readable-file.ts';

/** Bars of a strip. */
export const PREVIEW_PARTS = 96;

/** How much of a topic was recorded when. */
export interface PreviewTrack {
  readonly topic: string;
  /** The topic with the name of its client in place of the id. */
  readonly label: string;
  readonly family: DataFormatFamily;
  readonly records: number;
  readonly activity: Float32Array;
}

export interface PreviewMarker {
  /** Milliseconds since the beginning. */
  readonly timeMs: number;
  readonly text: string;
}

/** What a list shows of a recording. */
export interface RecordingPreview {
  readonly durationMs: number;
  readonly records: number;
  readonly topics: number;
  readonly activity: Float32Array;
  /** The busiest topics. */
  readonly tracks: readonly PreviewTrack[];
  /** By time; the first ones of a recording with many. */
  readonly markers: readonly PreviewMarker[];
  /** A picture follows, which may be undefined. */
  readonly hasPicture: boolean;
}

/** A recording whose preview is asked for. */
export interface PreviewRequest {
  readonly key: string;
  readonly source: ReadableFile;
}

/** What the page calls of the worker that reads previews. */
export interface PreviewWorker {
  readPreview(request: PreviewRequest): Promise<RecordingPreview>;
  /** Reads the picture of a preview that has one, once. @returns undefined when it cannot be decoded */
  readPicture(key: string): Promise<ImageBitmap | undefined>;
}
