import {
  Group,
  Mesh,
  SphereGeometry,
  BoxGeometry,
  MeshStandardMaterial,
  Vector3,
  type BufferGeometry,
} from 'three';

import {
  identityOf,
  PLATFORM_RADIUS,
  STEPS_PER_SECOND,
  type HillState,
  type Seat,
} from '../../../sim/index.ts';
import type { Framing } from '../../camera/camera-rig.ts';
import { ContactShades, GroundShade } from '../../light/ground-shade.ts';
import { HOURS } from '../../light/hours.ts';
import type { Paints } from '../../light/paints.ts';
import { FlyingBits, PulseRings } from '../../motion/effects.ts';
import { approach, scatter, StepClock } from '../../motion/motion.ts';
import { CrownMover } from '../../pieces/crown-mover.ts';
import type { PieceKit } from '../../pieces/piece-kit.ts';
import { PieceSet } from '../../pieces/piece.ts';
import { disposeToys } from '../../toys/toy-box.ts';
import { buildBlock, buildCone, buildCylinder } from '../../toys/turned.ts';
import type { Frame, SceneView } from '../scene-view.ts';
import { ChargeArcs, Offer, PowerMarks } from './hill-marks.ts';
import { glanceAtHill, hillEvents, type HillEvent, type HillGlance } from './hill-events.ts';
import { placePiece } from './hill-pieces.ts';
import { PLATFORM_Y } from './platform-motion.ts';
import { Platform } from './platform.ts';

const COLOUR = '#4e5c93';

/** Toys round the hill in the colour of the evening: there, but never in the way of the eye. */
function buildHillProps(paints: Paints): Group {
  const root = new Group();
  const add = (geometry: BufferGeometry, x: number, y: number, z: number, turn = 0): void => {
    const mesh = new Mesh(geometry, paints.of(COLOUR, 'matte'));
    mesh.position.set(x, y, z);
    mesh.rotation.y = turn;
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    root.add(mesh);
  };
  add(buildBlock(2.6, 2.6, 2.6, 0.14), -16.6, 0, -8.5, 0.35);
  add(buildBlock(2, 2, 2, 0.12), -16.7, 2.6, -8.5, -0.3);
  add(buildCylinder(1.6, 2.4, 0.16), 17, 0, -9.5);
  add(new SphereGeometry(1.35, 40, 28), 17, 3.6, -9.5);
  add(buildCone(1.7, 3.2, 0.16), 21.5, 0, -1.5);
  add(buildCone(1.2, 2.2, 0.14), -22, 0, 2);
  return root;
}

/** Degrees that the camera sways with a push. */
const SWAY_DEG = 0.5;
const CHIPS_OF_A_PUSH = 14;
const CHIPS_OF_A_DASH = 8;

const AROUND = Array.from({ length: 16 }, (_, index) => (index / 16) * Math.PI * 2);
const FRAMING: Framing = {
  pitchDeg: 28,
  points: [
    ...AROUND.map((angle) => ({
      x: Math.cos(angle) * (PLATFORM_RADIUS + 0.4),
      y: PLATFORM_Y + (Math.sin(angle) > 0 ? 3.2 : 0),
      z: -Math.sin(angle) * (PLATFORM_RADIUS + 0.4),
    })),
    ...[-1, 1].map((side) => ({ x: side * 15.4, y: 0, z: 3 })),
  ],
  rect: { left: 0.02, right: 0.98, top: 0.06, bottom: 0.8 },
  tallRect: { left: 0.01, right: 0.99, top: 0.2, bottom: 0.76 },
};

/** King of the Hill. */
export class HillScene implements SceneView<{ kind: 'hill'; state: HillState }> {
  readonly root = new Group();
  readonly hour = 'hill';
  readonly reach = 22;
  readonly framing = FRAMING;
  zoom = 1;
  swayDeg = 0;
  readonly #pieces: PieceSet;
  readonly #platform: Platform;
  readonly #offer: Offer;
  readonly #crown: CrownMover;
  readonly #arcs: ChargeArcs;
  readonly #marks: PowerMarks;
  readonly #chips: FlyingBits;
  readonly #rings: PulseRings;
  readonly #shades: ContactShades;
  readonly #ground: GroundShade;
  readonly #props: Group;
  readonly #clock = new StepClock();
  readonly #crownAt = new Vector3();
  readonly #chipPaint = new MeshStandardMaterial({ roughness: 0.7 });
  readonly #chipForm = new BoxGeometry(1, 0.7, 0.5);
  readonly #events: HillEvent[] = [];
  #glance: HillGlance | undefined;
  #state: HillState | undefined;
  #push = 0;

  constructor(kit: PieceKit) {
    this.#pieces = new PieceSet(this.root, kit, 'foot');
    this.#ground = new GroundShade(this.root, HOURS.hill);
    this.#shades = new ContactShades(this.root, HOURS.hill, 48);
    this.#platform = new Platform(this.root, kit.paints);
    this.#offer = new Offer(kit.paints);
    this.#crown = new CrownMover(kit);
    this.#crown.root.scale.setScalar(1.15);
    this.#arcs = new ChargeArcs(this.root);
    this.#marks = new PowerMarks(this.root, kit.paints);
    this.#chips = new FlyingBits(this.root, this.#chipForm, this.#chipPaint, 160);
    this.#rings = new PulseRings(this.root, '#fff6e4');
    this.#props = buildHillProps(kit.paints);
    this.root.add(this.#offer.root, this.#crown.root, this.#props);
  }

  show({ state }: { state: HillState }, nowMs: number): void {
    if (this.#glance) this.#events.push(...hillEvents(this.#glance, state));
    if (this.#glance?.step !== state.step) this.#clock.take(state.step, nowMs);
    this.#glance = glanceAtHill(state);
    this.#state = state;
    this.#pieces.keep(new Set(state.pieces.map(({ seat }) => seat)));
  }

  update(frame: Frame): void {
    const state = this.#state;
    if (!state) return;
    const { dtS, isReduced } = frame;
    for (const event of this.#events.splice(0)) this.#play(event, isReduced);
    const step = state.step + this.#clock.aheadS(frame.nowMs) * STEPS_PER_SECOND;
    this.#platform.update(step, state.radius, isReduced);
    this.#placePieces(state, step, frame);
    this.#offer.update(state.offer, dtS, isReduced);
    this.#chips.update(dtS, 0);
    this.#rings.update(dtS);
    this.#push *= 1 - approach(dtS, 0.12);
    this.swayDeg = this.#push * SWAY_DEG;
    // Zooms in as the platform shrinks, so that it fills the picture
    this.zoom = 1 + (0.12 * (PLATFORM_RADIUS - state.radius)) / PLATFORM_RADIUS;
  }

  footOf(seat: Seat, into: Vector3): number {
    const piece = this.#pieces.find(seat);
    if (!piece) return 0;
    into.copy(piece.root.position);
    return piece.height * piece.root.scale.y;
  }

  dispose(): void {
    for (const part of [this.#platform, this.#offer, this.#arcs, this.#marks, this.#chips])
      part.dispose();
    for (const part of [this.#rings, this.#shades, this.#ground]) part.dispose();
    this.#chipForm.dispose();
    this.#chipPaint.dispose();
    disposeToys(this.#props);
  }

  #placePieces(state: HillState, step: number, frame: Frame): void {
    this.#shades.begin();
    this.#shades.add(0, 0, 0, 21, 19);
    this.#crownAt.set(0, PLATFORM_Y + 0.06, 0);
    this.#marks.begin();
    for (const one of state.pieces) {
      const piece = this.#pieces.get(one.seat);
      const ground = placePiece(piece, one, state, step, frame);
      const { x, y, z } = piece.root.position;
      if (ground !== undefined) this.#shades.add(x, ground, z, 2.7, 2.3);
      this.#arcs.set(one.seat, one.outAt === undefined ? one.charge : 0, x, y, z);
      if (one.outAt === undefined) this.#marks.set(piece, one.power?.kind);
      if (one.seat === state.crown) {
        this.#crownAt.set(0, piece.height + 0.12, 0).applyQuaternion(piece.body.quaternion);
        this.#crownAt.multiplyScalar(piece.root.scale.x).add(piece.root.position);
      }
    }
    this.#shades.end();
    this.#crown.update(state.crown, this.#crownAt, frame.dtS, frame.isReduced);
  }

  /** A dash leaves chips of its paint behind. */
  #kickUp(seat: Seat): void {
    const one = this.#state?.pieces.find((piece) => piece.seat === seat);
    if (!one) return;
    const speed = Math.max(1, Math.hypot(one.velocity.x, one.velocity.y));
    const [x, z] = [one.velocity.x / speed, -one.velocity.y / speed];
    for (let chip = 0; chip < CHIPS_OF_A_DASH; chip += 1) {
      const aside = scatter(chip, seat) - 0.5;
      this.#chips.launch(
        {
          x: one.position.x - x - z * aside * 1.6,
          y: PLATFORM_Y + 0.15,
          z: -one.position.y - z + x * aside * 1.6,
          vx: -x * (2 + 3 * scatter(chip, 20)),
          vy: 2 + 2 * scatter(chip, 30),
          vz: -z * (2 + 3 * scatter(chip, 20)),
          size: 0.16 + 0.12 * scatter(chip, 40),
          lifeS: 0.4,
        },
        identityOf(seat).colour,
      );
    }
  }

  #play(event: HillEvent, isReduced: boolean): void {
    if (event.type === 'dash' && !isReduced) this.#kickUp(event.seat);
    if (event.type !== 'push') return;
    for (const seat of event.seats) this.#pieces.get(seat).hit(1);
    if (isReduced) {
      this.#rings.launch(event.x, PLATFORM_Y, -event.y);
      return;
    }
    this.#push += event.seats[0] % 2 === 0 ? 1 : -1;
    for (let chip = 0; chip < CHIPS_OF_A_PUSH; chip += 1) {
      const angle = scatter(chip, event.seats[0]) * Math.PI * 2;
      const out = 1 + 2.6 * scatter(chip, event.seats[1] + 40);
      this.#chips.launch(
        {
          x: event.x,
          y: PLATFORM_Y + 2.6,
          // From behind the tokens: never over a letter
          z: -event.y - 0.7,
          vx: Math.cos(angle) * out,
          vy: 4.5 + 4 * scatter(chip, 80),
          vz: -1.2 - Math.abs(Math.sin(angle)) * out * 0.6,
          size: 0.16 + 0.16 * scatter(chip, 90),
          lifeS: 1.1 + 0.6 * scatter(chip, 100),
        },
        chip % 5 === 4 ? '#fff6e4' : identityOf(event.seats[chip % 2 === 0 ? 0 : 1]).colour,
      );
    }
  }
}
