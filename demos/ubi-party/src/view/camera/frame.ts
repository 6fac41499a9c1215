import type { Vector3 } from 'three';
import type { Quality } from '../quality/quality.ts';

/** A frame that is drawn. */
export interface Frame {
  readonly nowMs: number;
  /** Since the frame before. */
  readonly dtS: number;
  readonly isReduced: boolean;
  readonly quality: Quality;
  /** Where the camera was in the frame before. */
  readonly eye: Readonly<Vector3>;
}
