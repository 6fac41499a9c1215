import type { Orbit, Up } from '../orbit.ts';
import type { Ground } from '../reach.ts';
import type { Point, SpaceThing } from '../space-things.ts';

/** Colours as CSS writes them. */
export interface SceneColors {
  readonly ground: string;
  readonly grid: string;
  readonly axis: string;
  /** Of x, y and z of turned things: one colour in three strengths. */
  readonly arms: readonly [string, string, string];
  readonly vector: string;
  readonly box: string;
}

/** Everything a picture of space is made of. */
export interface SceneInput {
  readonly things: readonly SpaceThing[];
  readonly ground: Ground;
  /** Radius of what the first picture shows: marks are as large as that wants. */
  readonly scale: number;
  readonly up: Up;
  readonly orbit: Orbit;
  readonly trails: ReadonlyMap<string, readonly Point[]>;
  readonly colors: SceneColors;
}

/** A word at a place of the picture. */
export interface SceneLabel {
  readonly key: string;
  readonly text: string;
  /** Of the room, of an arm of a thing, or a thing's own. */
  readonly kind: 'axis' | 'arm' | 'name';
  /** Pixels from the top left. */
  readonly left: number;
  readonly top: number;
}
