import { PerspectiveCamera, type Vector3 } from 'three';

import { approach } from '../motion/motion.ts';
import type { Quality } from '../quality/quality.ts';
import { fitCamera, type CameraPlace, type FrameRect, type Point3 } from './fit-camera.ts';

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

/** Framing that a scene requests of the camera. */
export interface Framing {
  readonly pitchDeg: number;
  /** Looks down as far as this where that fills a higher picture; `pitchDeg` by default. */
  readonly mostPitchDeg?: number;
  readonly yawDeg?: number;
  /** All that must be in the picture. */
  readonly points: readonly Point3[];
  /** Target rectangle in the picture: the rest is for texts. */
  readonly rect: FrameRect;
  /** The same for a picture that is higher than wide. */
  readonly tallRect: FrameRect;
}

export const FOV_DEG = 22;
/** Seconds in which half of the way to a new place is gone: no cuts during play. */
const FOLLOW_S = 0.35;
/** A steeper view of the same width is a little farther, as perspective has it. */
const NO_FARTHER = 1.03;

interface Place extends CameraPlace {
  readonly pitchDeg: number;
}

/** A camera that frames what a scene wants to be seen, follows it smoothly, and never rolls. */
export class CameraRig {
  readonly camera = new PerspectiveCamera(FOV_DEG, 16 / 9, 1, 400);
  #framing: Framing | undefined;
  #goal: Place | undefined;
  #at: Place | undefined;
  #aspect = 16 / 9;

  resize(aspect: number): void {
    this.#aspect = aspect;
    this.#goal = undefined;
    this.#at = undefined;
  }

  /** @param isCut at once, for a new scene */
  frame(framing: Framing, isCut = false): void {
    if (framing === this.#framing && !isCut) return;
    this.#framing = framing;
    this.#goal = undefined;
    if (isCut) this.#at = undefined;
  }

  /**
   * Places the camera.
   *
   * @param zoom above 1 is nearer, around a point of the table
   * @param swayDeg turned to the left, in addition to the framing
   */
  update(
    dtS: number,
    zoom: number,
    swayDeg: number,
    zoomAt?: { readonly x: number; readonly z: number },
  ): void {
    const framing = this.#framing;
    if (!framing) return;
    const yawDeg = framing.yawDeg ?? 0;
    this.#goal ??= steepestFit(framing, this.#aspect);
    const at = this.#at ? between(this.#at, this.#goal, approach(dtS, FOLLOW_S)) : this.#goal;
    this.#at = at;
    const { target } = at;
    // The zoom keeps this point at its place in the picture
    const share = zoomAt ? 1 - 1 / zoom : 0;
    const x = target.x + ((zoomAt?.x ?? 0) - target.x) * share;
    const z = target.z + ((zoomAt?.z ?? 0) - target.z) * share;
    this.#place({ ...at, target: { x, y: target.y, z } }, at.distance / zoom, yawDeg + swayDeg);
  }

  #place({ target, shiftX, shiftY, pitchDeg }: Place, distance: number, yawDeg: number): void {
    const [pitch, yaw] = [(pitchDeg * Math.PI) / 180, (yawDeg * Math.PI) / 180];
    const { camera } = this;
    camera.position.set(
      target.x + Math.sin(yaw) * Math.cos(pitch) * distance,
      target.y + Math.sin(pitch) * distance,
      target.z + Math.cos(yaw) * Math.cos(pitch) * distance,
    );
    camera.lookAt(target.x, target.y, target.z);
    camera.aspect = this.#aspect;
    camera.far = distance + 150;
    camera.updateProjectionMatrix();
    // A shifted lens: words have their room, and the perspective of the scene stays
    camera.projectionMatrix.elements[8] = -shiftX;
    camera.projectionMatrix.elements[9] = -shiftY;
    camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
    camera.updateMatrixWorld();
  }
}

/** Looks down further as long as the camera need not go back: then the width is what limits it. */
function steepestFit(framing: Framing, aspect: number): Place {
  const { points, pitchDeg, mostPitchDeg = pitchDeg, yawDeg = 0 } = framing;
  const rect = aspect < 1 ? framing.tallRect : framing.rect;
  const fit = (deg: number): Place => ({
    ...fitCamera(points, { fovDeg: FOV_DEG, pitchDeg: deg, yawDeg, aspect }, rect),
    pitchDeg: deg,
  });
  let best = fit(pitchDeg);
  const farthest = best.distance * NO_FARTHER;
  for (let deg = pitchDeg + 1; deg <= mostPitchDeg; deg += 1) {
    const steeper = fit(deg);
    if (steeper.distance > farthest) break;
    best = steeper;
  }
  return best;
}

function between(a: Place, b: Place, share: number): Place {
  const mix = (from: number, to: number): number => from + (to - from) * share;
  return {
    target: {
      x: mix(a.target.x, b.target.x),
      y: mix(a.target.y, b.target.y),
      z: mix(a.target.z, b.target.z),
    },
    distance: mix(a.distance, b.distance),
    pitchDeg: mix(a.pitchDeg, b.pitchDeg),
    shiftX: mix(a.shiftX, b.shiftX),
    shiftY: mix(a.shiftY, b.shiftY),
  };
}
