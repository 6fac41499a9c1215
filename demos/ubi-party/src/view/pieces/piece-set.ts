import type { Group } from 'three';
import type { Seat } from '../../sim/index.ts';
import type { PieceKit } from './piece-kit.ts';
import { Piece, type Stand } from './piece.ts';

/** The pieces of a scene by seat. */
export class PieceSet {
  readonly #pieces = new Map<Seat, Piece>();
  readonly #root: Group;
  readonly #kit: PieceKit;
  readonly #stand: Stand;

  constructor(root: Group, kit: PieceKit, stand: Stand) {
    this.#root = root;
    this.#kit = kit;
    this.#stand = stand;
  }

  /** The piece of a seat, which is made when it is not there yet. */
  get(seat: Seat): Piece {
    let piece = this.#pieces.get(seat);
    if (!piece) {
      piece = new Piece(seat, this.#kit, this.#stand);
      this.#pieces.set(seat, piece);
      this.#root.add(piece.root);
    }
    return piece;
  }

  find(seat: Seat): Piece | undefined {
    return this.#pieces.get(seat);
  }

  /** Removes the pieces of all other seats. */
  keep(seats: ReadonlySet<Seat>): void {
    for (const [seat, piece] of this.#pieces) {
      if (seats.has(seat)) continue;
      piece.root.removeFromParent();
      this.#pieces.delete(seat);
    }
  }

  [Symbol.iterator](): IterableIterator<Piece> {
    return this.#pieces.values();
  }
}
