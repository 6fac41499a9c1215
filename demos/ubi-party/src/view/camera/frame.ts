import type { Vector3 } from 'three';
import type { Quality } from '../quality/quality.ts';

/** A frame that is drawn. */
export interface Frame {
  readonly nowMs: number;
  /** Since the frame before. */
  readonly dtS: number;
  readonly isReduced: boolean;
  readonly quality: Quality;
  /** Position of the camera in the previous frame. */
  readonly eye: Readonly<Vector3>;
}
