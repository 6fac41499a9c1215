import type { Sighting } from './accuracy.ts';

/** Backends of TensorFlow.js that a worker of this browser may have. */
export type DetectionBackend = 'wasm' | 'webgl' | 'webgpu';

/** A picture on its way to a worker with a detector's own library, which is given its pixels. */
export interface LibraryCall {
  readonly backend: DetectionBackend;
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
}

export type LibraryAnswer = { readonly seen: readonly Sighting[] } | { readonly error: string };
