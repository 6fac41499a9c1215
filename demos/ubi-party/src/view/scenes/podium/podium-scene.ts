import { Group, Vector3, type BufferGeometry, type MeshStandardMaterial } from 'three';

import { identityOf, type Seat, type Player } from '../../../sim/index.ts';
import type { Framing } from '../../camera/camera-rig.ts';
import { ContactShades, GroundShade } from '../../light/ground-shade.ts';
import { HOURS } from '../../light/hours.ts';
import type { Paints } from '../../light/paints.ts';
import { FlyingBits } from '../../motion/effects.ts';
import { scatter } from '../../motion/motion.ts';
import { CrownMover } from '../../pieces/crown-mover.ts';
import type { PieceKit } from '../../pieces/piece-kit.ts';
import { StandingPieces, yawOf } from '../../pieces/standing-pieces.ts';
import { buildConfetti } from '../../pieces/token-geometry.ts';
import type { Frame, SceneView } from '../scene-view.ts';
import { podiumSpots, STEP_DEPTH, STEPS, PodiumSteps, type PodiumSpot } from './podium-steps.ts';

const LASTS_S = 5;
const PIECES = 260;
/** It lies there until the scene ends. */
const LIFE_S = 600;

/** Confetti in the shapes and colours of the players: it falls for five seconds, then it lies there. */
class Confetti {
  readonly #kinds: { readonly bits: FlyingBits; readonly form: BufferGeometry }[] = [];
  #launched = 0;
  #timeS = 0;

  constructor(root: Group, paints: Paints, seats: readonly Seat[]) {
    const looks = new Map(seats.map((seat) => [identityOf(seat).shape, identityOf(seat)]));
    const each = Math.ceil(PIECES / Math.max(1, looks.size));
    for (const { shape, colour } of looks.values()) {
      const form = buildConfetti(shape);
      const paint: MeshStandardMaterial = paints.of(colour);
      const bits = new FlyingBits(root, form, paint, each, 0.85);
      // Their shadows would be far away from them
      bits.mesh.castShadow = false;
      this.#kinds.push({ form, bits });
    }
  }

  update(dtS: number): void {
    this.#timeS += dtS;
    const due = Math.floor(PIECES * Math.min(1, this.#timeS / LASTS_S));
    for (; this.#launched < due && this.#kinds.length > 0; this.#launched += 1) this.#launch();
    for (const { bits } of this.#kinds) bits.update(dtS, 0);
  }

  dispose(): void {
    for (const { bits, form } of this.#kinds) {
      bits.dispose();
      form.dispose();
    }
  }

  #launch(): void {
    const index = this.#launched;
    const at = (salt: number): number => scatter(index, salt);
    this.#kinds[index % this.#kinds.length]!.bits.launch({
      x: (at(1) - 0.5) * 24,
      y: 11 + at(2) * 4,
      z: (at(3) - 0.4) * 11,
      vx: (at(4) - 0.5) * 5,
      vy: at(5) * 3,
      vz: (at(6) - 0.5) * 4,
      size: 0.26 + at(7) * 0.26,
      lifeS: LIFE_S,
    });
  }
}

/** Units that each of the first three hops, and the seconds between two hops. */
const HOPS = [
  { height: 1.3, everyS: 1.15 },
  { height: 0.7, everyS: 1.7 },
  { height: 0.45, everyS: 2.1 },
] as const;

/** The three best on wooden steps, the others before them. */
export class PodiumScene implements SceneView<{
  kind: 'podium';
  players: readonly Player[];
  first: readonly Seat[];
}> {
  readonly root = new Group();
  readonly hour = 'podium';
  readonly reach = 20;
  readonly zoom = 1;
  readonly swayDeg = 0;
  framing: Framing = framingOf([]);
  readonly #kit: PieceKit;
  readonly #pieces: StandingPieces;
  readonly #ground: GroundShade;
  readonly #shades: ContactShades;
  readonly #steps: PodiumSteps;
  readonly #crown: CrownMover;
  readonly #crownAt = new Vector3();
  #confetti: Confetti | undefined;
  #first: readonly Seat[] = [];
  #key = '';
  #timeS = 0;

  constructor(kit: PieceKit) {
    this.#kit = kit;
    this.#ground = new GroundShade(this.root, HOURS.podium);
    this.#shades = new ContactShades(this.root, HOURS.podium, 48);
    this.#pieces = new StandingPieces(this.root, kit, 'table');
    this.#steps = new PodiumSteps(kit.paints);
    this.#crown = new CrownMover(kit);
    this.#crown.root.scale.setScalar(1.75);
    this.root.add(this.#steps.root, this.#crown.root);
  }

  show({ players, first }: { players: readonly Player[]; first: readonly Seat[] }): void {
    const spots = podiumSpots(
      players.map(({ seat }) => seat),
      first,
    );
    const key = JSON.stringify(spots);
    if (key !== this.#key) {
      this.#key = key;
      this.framing = framingOf(spots);
    }
    this.#first = spots.filter(({ place }) => place > 0).map(({ seat }) => seat);
    const away = new Set(
      players.filter(({ awaySinceMs }) => awaySinceMs !== undefined).map(({ seat }) => seat),
    );
    this.#pieces.show(
      spots.map((spot) => ({
        ...spot,
        yaw: spot.place > 0 ? yawOf(spot.seat, 0.1) : yawOf(spot.seat, 0.25),
        isLying: spot.place === 0 && away.has(spot.seat),
      })),
      true,
    );
    this.#confetti ??= new Confetti(
      this.root,
      this.#kit.paints,
      players.map(({ seat }) => seat),
    );
  }

  update(frame: Frame): void {
    const before = this.#timeS;
    this.#timeS += frame.dtS;
    for (const [index, seat] of this.#first.entries()) {
      const { height, everyS } = HOPS[index]!;
      // The first hop is after all have dropped in
      const turn = (timeS: number): number => Math.floor((timeS - 1.2) / everyS);
      if (turn(this.#timeS) > Math.max(-1, turn(before))) this.#pieces.hop(seat, height);
    }
    this.#shades.begin();
    this.#shades.add(0.3, 0, 0.4, 16, 6.4);
    this.#pieces.update(frame, this.#shades);
    this.#shades.end();
    if (!frame.isReduced) this.#confetti?.update(frame.dtS);
    this.#placeCrown(frame);
  }

  footOf(seat: Seat, into: Vector3): number {
    return this.#pieces.footOf(seat, into);
  }

  dispose(): void {
    for (const part of [this.#ground, this.#shades, this.#steps]) part.dispose();
    this.#confetti?.dispose();
  }

  #placeCrown({ dtS, isReduced }: Frame): void {
    const [winner] = this.#first;
    const piece = winner === undefined ? undefined : this.#pieces.find(winner);
    this.#crown.root.visible = piece !== undefined;
    if (!piece) return;
    const { position, scale } = piece.root;
    this.#crownAt.copy(position);
    this.#crownAt.y += (piece.height * piece.body.scale.y + 0.2) * scale.x;
    this.#crown.update(winner, this.#crownAt, dtS, isReduced);
  }
}

/** The table of the tournament stands at the right. */
function framingOf(spots: readonly PodiumSpot[]): Framing {
  const first = STEPS.find(({ place }) => place === 1)!;
  const front = Math.max(STEP_DEPTH / 2 + 1.6, ...spots.map(({ z }) => z + 0.8));
  return {
    pitchDeg: 14,
    points: [
      { x: -6.5, y: 0, z: 1 },
      { x: 7.7, y: 0, z: 1 },
      { x: first.x, y: first.height + 6, z: 0 },
      { x: 0, y: 0, z: front },
      ...spots
        .filter(({ place }) => place === 0)
        .flatMap(({ x, z }) => [
          { x: x - 1, y: 0, z },
          { x: x + 1, y: 0, z },
        ]),
    ],
    rect: { left: 0.04, right: 0.575, top: 0.1, bottom: 0.89 },
    tallRect: { left: 0.04, right: 0.96, top: 0.09, bottom: 0.43 },
  };
}
