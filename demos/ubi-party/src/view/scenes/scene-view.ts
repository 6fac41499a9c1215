import type { Group, Vector3 } from 'three';
import type { Seat } from '../../sim/index.ts';
import type { Framing, Frame } from '../camera/camera-rig.ts';
export type { Frame } from '../camera/camera-rig.ts';
import type { HOURS } from '../light/hours.ts';
import type { Scene } from '../stage.ts';

/** One kind of scene. It is made when it is shown first, and disposed when another kind is shown. */
export interface SceneView<S extends Scene = Scene> {
  readonly root: Group;
  readonly hour: keyof typeof HOURS;
  /** Units from the origin in which things have shadows. */
  readonly reach: number;
  /** Framing of the camera; the same object until it changes. */
  readonly framing: Framing;
  /** Above 1 is nearer than the framing needs. */
  readonly zoom: number;
  /** The point that a zoom leaves where it is in the picture; else it is the middle of the framing. */
  readonly zoomAt?: { readonly x: number; readonly z: number };
  readonly swayDeg: number;
  /** The next state. It may be the same object, changed. */
  show(scene: S, nowMs: number): void;
  update(frame: Frame): void;
  /** Position of a seat's token. @returns units up to its top; 0 when it is not there */
  footOf(seat: Seat, into: Vector3): number;
  dispose(): void;
}
