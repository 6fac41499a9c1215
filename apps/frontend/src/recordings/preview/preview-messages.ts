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

/** What the page asks of the worker that reads previews. */
export interface PreviewRequest {
  readonly key: string;
  readonly source: ReadableFile;
}

/** What the worker says. */
export type PreviewReport =
  | { readonly kind: 'preview'; readonly key: string; readonly preview: RecordingPreview }
  | { readonly kind: 'picture'; readonly key: string; readonly picture: ImageBitmap | undefined }
  | { readonly kind: 'failed'; readonly key: string; readonly message: string };
