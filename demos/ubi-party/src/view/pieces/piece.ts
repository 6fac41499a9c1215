import { Group, Mesh, type Object3D } from 'three';

import { identityOf, type Seat } from '../../sim/index.ts';
import { Spring } from '../motion/motion.ts';
import { BASE_HEIGHT } from '../toys/piece-parts.ts';
import { outlineOf, letterDepth } from './token-geometry.ts';
import type { PieceKit } from './piece-kit.ts';

/** On what a token stands. Seats whose shape is taken already always have a ringed foot. */
export type Stand = 'foot' | 'table';

/** A token with its letter, on its foot. Its origin is on the ground, below its middle. */
export class Piece {
  readonly seat: Seat;
  /** Placed by the scene. */
  readonly root = new Group();
  /** Leans and is squashed, with the foot. */
  readonly body = new Group();
  /** Turns to the camera; the foot below it does not. */
  readonly token = new Group();
  /** Units from the ground to the top of the token. */
  readonly height: number;
  /** Units from its axis to its side. */
  readonly halfWidth: number;
  readonly hasFoot: boolean;
  /** Of the body's height. */
  readonly squash = new Spring(1, 260, 11);
  readonly leanX = new Spring(0);
  readonly leanZ = new Spring(0);

  constructor(seat: Seat, kit: PieceKit, stand: Stand) {
    this.seat = seat;
    const { colour, shape, isRinged, onColour } = identityOf(seat);
    const paint = kit.paints.of(colour);
    const hasFoot = stand === 'foot' || isRinged;
    this.hasFoot = hasFoot;
    const lift = hasFoot ? BASE_HEIGHT : 0;
    const { max } = kit.token(seat).boundingBox!;
    this.height = lift + max.y;
    this.halfWidth = hasFoot ? Math.max(0.86, max.x) : max.x;

    this.token.position.y = lift;
    this.token.add(solid(new Mesh(kit.token(seat), paint)));
    const letter = new Mesh(kit.letters.square(seat), kit.letters.material(onColour.letter));
    const at = outlineOf(shape).letter;
    letter.position.set(at.x, at.y, letterDepth(shape));
    letter.scale.setScalar(at.size);
    this.token.add(letter);

    this.body.add(this.token);
    if (hasFoot) {
      this.body.add(solid(new Mesh(kit.foot, kit.paints.of('#fff6e4'))));
      this.body.add(solid(new Mesh(kit.neck, paint)));
    }
    if (isRinged) {
      const ring = colour === '#221c14' ? onColour.letter : '#221c14';
      this.body.add(solid(new Mesh(kit.footRing, kit.paints.of(ring))));
    }
    this.root.add(this.body);
  }

  /** Leans, and gives when it is hit. */
  settle(dtS: number, leanX: number, leanZ: number, isStill: boolean): void {
    if (isStill) {
      this.squash.set(1);
      this.leanX.set(0);
      this.leanZ.set(0);
    } else {
      this.squash.step(1, dtS);
      this.leanX.step(leanX, dtS);
      this.leanZ.step(leanZ, dtS);
    }
    const high = this.squash.value;
    this.body.scale.set(1 / Math.sqrt(high), high, 1 / Math.sqrt(high));
    this.body.rotation.set(this.leanX.value, 0, this.leanZ.value);
  }

  /** Squashed by a blow. @param share of the usual 8 % */
  hit(share: number): void {
    this.squash.speed = -2.6 * share;
  }
}

function solid<T extends Object3D>(mesh: T): T {
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  return mesh;
}

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
