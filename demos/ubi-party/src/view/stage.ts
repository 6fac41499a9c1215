import type { DuelState, HillState, Player, RaceState, Seat, TablePiece } from '../sim/index.ts';

/** What the stage shows. */
export type Scene =
  | {
      readonly kind: 'lobby';
      readonly players: readonly Player[];
      /** What stands beside the pieces: how to join, or how the next game is played, which is wider. */
      readonly words: 'join' | 'explanation';
    }
  | {
      readonly kind: 'podium';
      readonly players: readonly Player[];
      readonly first: readonly Seat[];
    }
  | { readonly kind: 'race'; readonly state: RaceState }
  | { readonly kind: 'hill'; readonly state: HillState }
  | { readonly kind: 'duel'; readonly state: DuelState }
  /** A game without a scene of its own. */
  | {
      readonly kind: 'pieces';
      readonly pieces: readonly TablePiece[];
      /** The table has a mat at the left and one at the right. */
      readonly hasSides: boolean;
    };

/** A token in the picture, CSS pixels. */
export interface TokenPlace {
  readonly x: number;
  readonly y: number;
  readonly height: number;
}

/** The three-dimensional part of the big screen; words stand on a page above it. */
export interface Stage {
  /** Shows a scene, or the next state of the one that is shown. May be called more often than frames are drawn. */
  show(scene: Scene): void;
  /** No swaying camera, no confetti, fades instead of springs. */
  setReducedMotion(isReduced: boolean): void;
  /**
   * Where the token of a seat stands, CSS pixels from the top left of the canvas, and how high it is above this point;
   * undefined while it is not seen. A name goes below this point. A hop does not move it, so that names are still.
   */
  placeOf(seat: Seat): TokenPlace | undefined;
  /** Milliseconds between the newest frames, and the level of quality that they lead to. */
  readonly frames: { readonly p95Ms: number; readonly quality: 'low' | 'middle' | 'high' };
  dispose(): void;
}
