import { PerspectiveCamera } from 'three';
import { approach } from '../motion/ease.ts';
import { fitCamera, type CameraPlace, type FrameRect, type Point3 } from './fit-camera.ts';

/** What a scene wants to be seen. */
export interface Framing {
  readonly pitchDeg: number;
  readonly yawDeg?: number;
  /** All that must be in the picture. */
  readonly points: readonly Point3[];
  /** Where in the picture: the rest is for words. */
  readonly rect: FrameRect;
  /** The same for a picture that is higher than wide. */
  readonly tallRect: FrameRect;
}

export const FOV_DEG = 22;
/** Seconds in which half of the way to a new place is gone: no cuts during play. */
const FOLLOW_S = 0.35;

/** A camera that frames what a scene wants to be seen, follows it smoothly, and never rolls. */
export class CameraRig {
  readonly camera = new PerspectiveCamera(FOV_DEG, 16 / 9, 1, 400);
  #framing: Framing | undefined;
  #goal: CameraPlace | undefined;
  #at: CameraPlace | undefined;
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
    this.#goal ??= fitCamera(
      framing.points,
      { fovDeg: FOV_DEG, pitchDeg: framing.pitchDeg, yawDeg, aspect: this.#aspect },
      this.#aspect < 1 ? framing.tallRect : framing.rect,
    );
    const at = this.#at ? between(this.#at, this.#goal, approach(dtS, FOLLOW_S)) : this.#goal;
    this.#at = at;
    const { target } = at;
    // What is at the point stays at its place in the picture
    const share = zoomAt ? 1 - 1 / zoom : 0;
    const x = target.x + ((zoomAt?.x ?? 0) - target.x) * share;
    const z = target.z + ((zoomAt?.z ?? 0) - target.z) * share;
    this.#place(
      { ...at, target: { x, y: target.y, z } },
      at.distance / zoom,
      framing.pitchDeg,
      yawDeg + swayDeg,
    );
  }

  #place(
    { target, shiftX, shiftY }: CameraPlace,
    distance: number,
    pitchDeg: number,
    yawDeg: number,
  ): void {
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

function between(a: CameraPlace, b: CameraPlace, share: number): CameraPlace {
  const mix = (from: number, to: number): number => from + (to - from) * share;
  return {
    target: {
      x: mix(a.target.x, b.target.x),
      y: mix(a.target.y, b.target.y),
      z: mix(a.target.z, b.target.z),
    },
    distance: mix(a.distance, b.distance),
    shiftX: mix(a.shiftX, b.shiftX),
    shiftY: mix(a.shiftY, b.shiftY),
  };
}
