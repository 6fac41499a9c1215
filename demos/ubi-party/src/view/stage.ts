import type { DuelState, HillState, Player, RaceState, Seat, TablePiece } from '../sim/index.ts';

/** Scene of the stage. */
export type Scene =
  | {
      readonly kind: 'lobby';
      readonly players: readonly Player[];
      /** Content of the panel beside the pieces: join instructions, or the wider explanation of the next game. */
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
   * Position of a seat's token, CSS pixels from the top left of the canvas, and its height above this point; undefined
   * while it is not visible. A name goes below this point. Hops are ignored, so that names do not move.
   */
  placeOf(seat: Seat): TokenPlace | undefined;
  /** Milliseconds between the newest frames, and the level of quality that they lead to. */
  readonly frames: { readonly p95Ms: number; readonly quality: 'low' | 'middle' | 'high' };
  dispose(): void;
}
