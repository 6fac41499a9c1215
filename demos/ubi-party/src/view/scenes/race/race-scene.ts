import { Group, Mesh, MeshStandardMaterial, Vector3 } from 'three';

import {
  lapOf,
  placeAt,
  trackOf,
  type RaceState,
  type Track,
  type Seat,
} from '../../../sim/index.ts';
import type { Framing } from '../../camera/camera-rig.ts';
import { ContactShades, GroundShade } from '../../light/ground-shade.ts';
import { HOURS } from '../../light/hours.ts';
import { mix, smooth, approach, StepClock } from '../../motion/motion.ts';
import { CrownMover } from '../../pieces/crown-mover.ts';
import type { PieceKit } from '../../pieces/piece-kit.ts';
import type { Frame, SceneView } from '../scene-view.ts';
import { standInCrowd } from './crowd.ts';
import {
  RaceBits,
  glanceAtRace,
  leaderOf,
  raceEvents,
  type RaceEvent,
  type RaceGlance,
} from './race-effects.ts';
import { RaceCarts } from './race-carts.ts';
import { RaceScenery } from './race-scenery.ts';
import { buildRoad, roadHeight } from './road.ts';
import { boundsOf } from './scenery.ts';

/** The camera closes in by so much on the last lap. */
const LAST_LAP = 1.15;
/** Shares of half of the circuit's width: carts that are further apart than the second need the whole picture. */
const NEAR = 0.45;
const FAR = 0.85;

/** Zoom of the camera, and the point of the table that keeps its place in the picture. */
interface CloseIn {
  readonly zoom: number;
  readonly x: number;
  readonly z: number;
}

/** On the last lap of the first, around the carts that still drive, as long as all stay in the picture. */
export function closeIn({ carts }: RaceState, track: Track, halfWidth: number): CloseIn {
  const driving = carts.filter(({ finishedAt }) => finishedAt === undefined);
  const seen = driving.length > 0 ? driving : carts;
  const xs = seen.map(({ position }) => position.x);
  const ys = seen.map(({ position }) => position.y);
  const middle = (values: readonly number[]): number =>
    values.length === 0 ? 0 : (Math.min(...values) + Math.max(...values)) / 2;
  const [x, y] = [middle(xs), middle(ys)];
  const isLast = carts.some((cart) => lapOf(cart, track) === track.laps);
  const spread = Math.max(0, ...xs.map((at) => Math.abs(at - x))) / halfWidth;
  const zoom = isLast ? mix(LAST_LAP, 1, smooth((spread - NEAR) / (FAR - NEAR))) : 1;
  return { zoom, x, z: -y };
}

/** Marble Dash. */
export class RaceScene implements SceneView<{ kind: 'race'; state: RaceState }> {
  readonly root = new Group();
  readonly hour = 'race';
  readonly reach = 42;
  readonly swayDeg = 0;
  zoom = 1;
  readonly zoomAt = { x: 0, z: 0 };
  framing: Framing = NOTHING;
  readonly #kit: PieceKit;
  readonly #ground: GroundShade;
  readonly #shades: ContactShades;
  readonly #crown: CrownMover;
  readonly #crownAt = new Vector3();
  readonly #clock = new StepClock();
  readonly #roadPaint = new MeshStandardMaterial({ vertexColors: true, roughness: 0.8 });
  readonly #events: RaceEvent[] = [];
  readonly #bits: RaceBits;
  #world:
    | {
        readonly track: Track;
        readonly road: Mesh;
        readonly carts: RaceCarts;
        readonly scenery: RaceScenery;
      }
    | undefined;
  #glance: RaceGlance | undefined;
  #state: RaceState | undefined;

  constructor(kit: PieceKit) {
    this.#kit = kit;
    this.#ground = new GroundShade(this.root, HOURS.race, 320);
    this.#shades = new ContactShades(this.root, HOURS.race, 96);
    this.#bits = new RaceBits(this.root);
    this.#crown = new CrownMover(kit);
    this.#crown.root.scale.setScalar(2.5);
    this.root.add(this.#crown.root);
  }

  show({ state }: { state: RaceState }, nowMs: number): void {
    const track = trackOf(state);
    if (track !== this.#world?.track) this.#lay(track);
    if (this.#glance) this.#events.push(...raceEvents(this.#glance, state));
    if (this.#glance?.step !== state.step) this.#clock.take(state.step, nowMs);
    this.#glance = glanceAtRace(state);
    this.#state = state;
    this.#world!.carts.keep(new Set(state.carts.map(({ seat }) => seat)));
  }

  update(frame: Frame): void {
    const [state, world] = [this.#state, this.#world];
    if (!state || !world) return;
    const { track, carts, scenery } = world;
    const aheadS = this.#clock.aheadS(frame.nowMs);
    const leader = leaderOf(state);
    this.#shades.begin();
    for (const { x, z, size } of scenery.shades) this.#shades.add(x, 0, z, size, size * 0.8);
    const stands = standInCrowd(
      state.carts.map(({ seat, position: { x, y } }) => {
        return { x, z: -y, isCrowned: seat === leader };
      }),
    );
    for (const [index, cart] of state.carts.entries()) {
      const { x, y, z } = carts.place(cart, stands[index]!, aheadS, frame);
      this.#shades.add(x, roadHeight(track, cart.distance) + 0.04, z, 6, 4.6);
      this.#bits.trail(cart, y, frame);
      if (cart.seat === leader) this.#followCrown(carts, leader, x, y, z);
    }
    this.#shades.end();
    for (const { type, seat } of this.#events.splice(0)) {
      if (type !== 'hit') continue;
      carts.piece(seat)?.hit(1);
      const cart = state.carts.find((one) => one.seat === seat);
      if (cart) this.#bits.hit(cart, roadHeight(track, cart.distance), frame.isReduced);
    }
    this.#bits.update(frame.dtS);
    this.#crown.root.visible = state.step > 60 && leader !== undefined;
    this.#crown.update(leader, this.#crownAt, frame.dtS, frame.isReduced);
    this.#closeIn(state, track, frame);
  }

  footOf(seat: Seat, into: Vector3): number {
    const piece = this.#world?.carts.piece(seat);
    if (!piece?.root.parent) return 0;
    into.copy(piece.root.parent.position);
    return piece.root.position.y + piece.height * piece.root.scale.y;
  }

  dispose(): void {
    this.#clear();
    for (const part of [this.#ground, this.#shades, this.#bits, this.#roadPaint]) part.dispose();
  }

  #closeIn(state: RaceState, track: Track, { dtS }: Frame): void {
    const { minX, maxX } = boundsOf(track);
    const goal = closeIn(state, track, (maxX - minX) / 2);
    const share = approach(dtS, 0.9);
    this.zoom += (goal.zoom - this.zoom) * share;
    this.zoomAt.x += (goal.x - this.zoomAt.x) * share;
    this.zoomAt.z += (goal.z - this.zoomAt.z) * share;
  }

  #followCrown(carts: RaceCarts, leader: Seat, x: number, y: number, z: number): void {
    const piece = carts.piece(leader)!;
    this.#crownAt.set(0, piece.height + 0.1, 0).applyEuler(piece.root.rotation);
    this.#crownAt.multiplyScalar(piece.root.scale.x);
    this.#crownAt.x += x;
    this.#crownAt.y += y + piece.root.position.y;
    this.#crownAt.z += z;
  }

  #lay(track: Track): void {
    this.#clear();
    const road = new Mesh(buildRoad(track), this.#roadPaint);
    road.castShadow = true;
    road.receiveShadow = true;
    const scenery = new RaceScenery(track, this.#kit.paints);
    const carts = new RaceCarts(this.root, this.#kit, track);
    this.root.add(road, scenery.root);
    this.#world = { track, road, carts, scenery };
    this.#glance = undefined;
    this.framing = framingOf(track);
  }

  #clear(): void {
    if (!this.#world) return;
    const { road, scenery, carts } = this.#world;
    carts.keep(new Set());
    carts.dispose();
    scenery.dispose();
    road.geometry.dispose();
    road.removeFromParent();
    scenery.root.removeFromParent();
    this.#world = undefined;
  }
}

const NOTHING: Framing = {
  pitchDeg: 36,
  points: [
    { x: -30, y: 0, z: -20 },
    { x: 30, y: 0, z: 20 },
  ],
  rect: { left: 0, right: 1, top: 0, bottom: 1 },
  tallRect: { left: 0, right: 1, top: 0, bottom: 1 },
};

/** The whole circuit, with the tokens that stand on it; the table of places is at the left. */
function framingOf(track: Track): Framing {
  const points = track.points.filter((_, index) => index % 4 === 0);
  return {
    pitchDeg: 36,
    mostPitchDeg: 50,
    points: points.flatMap(({ distance }) => {
      const { position, direction } = placeAt(track, distance);
      const edge = track.halfWidth + 1;
      return [-edge, edge].flatMap((away) => {
        const [x, z] = [position.x - direction.y * away, -(position.y + direction.x * away)];
        return [
          { x, y: 0, z },
          { x, y: 5.5, z },
        ];
      });
    }),
    rect: { left: 0.24, right: 0.985, top: 0.12, bottom: 0.94 },
    tallRect: { left: 0.05, right: 0.95, top: 0.38, bottom: 0.84 },
  };
}
