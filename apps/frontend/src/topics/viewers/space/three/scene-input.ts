import type { Orbit, Up } from '../orbit.ts';
import type { Ground } from '../reach.ts';
import type { Point, SpaceThing } from '../space-things.ts';

/** Colours in CSS syntax. */
export interface SceneColors {
  readonly ground: string;
  readonly grid: string;
  readonly axis: string;
  /** Colours of x, y and z axes of rotated objects: one colour in three intensities. */
  readonly arms: readonly [string, string, string];
  readonly vector: string;
  readonly box: string;
}

/** Input of a scene. */
export interface SceneInput {
  readonly things: readonly SpaceThing[];
  readonly ground: Ground;
  /** Radius of the initially visible sphere, which determines the size of marks. */
  readonly scale: number;
  readonly up: Up;
  readonly orbit: Orbit;
  readonly trails: ReadonlyMap<string, readonly Point[]>;
  readonly colors: SceneColors;
}

/** Text at a position in the picture. */
export interface SceneLabel {
  readonly key: string;
  readonly text: string;
  /** Label of a coordinate axis, of an object's axis, or of an object. */
  readonly kind: 'axis' | 'arm' | 'name';
  /** Pixels from the top left. */
  readonly left: number;
  readonly top: number;
}
