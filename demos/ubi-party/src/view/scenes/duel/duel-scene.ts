import { Group, Vector3 } from 'three';
import { isSignalled, type DuelState, type Seat } from '../../../sim/index.ts';
import type { Framing } from '../../camera/camera-rig.ts';
import { ContactShades, GroundShade } from '../../light/ground-shade.ts';
import { HOURS } from '../../light/hours.ts';
import { PulseRings } from '../../motion/pulse-rings.ts';
import { CrownMover } from '../../pieces/crown-mover.ts';
import type { PieceKit } from '../../pieces/piece-kit.ts';
import { StandingPieces } from '../../pieces/standing-pieces.ts';
import { disposeToys } from '../../toys/toy-box.ts';
import type { Frame, SceneView } from '../scene-view.ts';
import {
  duelEvents,
  glanceAtDuel,
  isEarly,
  nextFlag,
  type DuelEvent,
  type DuelGlance,
} from './duel-events.ts';
import { duelSpots, type DuelSpot } from './duel-spots.ts';
import { buildDuelProps } from './duel-props.ts';
import { Flag } from './flag.ts';

const FLAG_Z = -6.5;
/** The winner of a bout hops so often, so high (units). */
const HOPS = { count: 3, height: 1.5 } as const;

/** Quick Draw: all wait for the flag to fall. */
export class DuelScene implements SceneView<{ kind: 'duel'; state: DuelState }> {
  readonly root = new Group();
  readonly hour = 'duel';
  readonly reach = 28;
  readonly zoom = 1;
  readonly swayDeg = 0;
  framing: Framing = framingOf([]);
  readonly #pieces: StandingPieces;
  readonly #ground: GroundShade;
  readonly #shades: ContactShades;
  readonly #flag: Flag;
  readonly #props: Group;
  readonly #rings: PulseRings;
  readonly #crown: CrownMover;
  readonly #crownAt = new Vector3();
  readonly #events: DuelEvent[] = [];
  #spots: readonly DuelSpot[] = [];
  #glance: DuelGlance | undefined;
  #state: DuelState | undefined;
  #flagHeight = 1;
  #timeS = 0;
  #hopper: Seat | undefined;
  #hopUntilS = 0;

  constructor(kit: PieceKit) {
    this.#ground = new GroundShade(this.root, HOURS.duel);
    this.#shades = new ContactShades(this.root, HOURS.duel, 48);
    this.#pieces = new StandingPieces(this.root, kit, 'foot');
    this.#flag = new Flag(kit.paints);
    this.#flag.root.position.z = FLAG_Z;
    this.#rings = new PulseRings(this.root, '#fff6e4');
    this.#crown = new CrownMover(kit);
    this.#crown.root.scale.setScalar(1.2);
    this.#props = buildDuelProps(kit.paints);
    this.root.add(this.#flag.root, this.#crown.root, this.#props);
  }

  show({ state }: { state: DuelState }): void {
    if (this.#glance) this.#events.push(...duelEvents(this.#glance, state));
    this.#glance = glanceAtDuel(state);
    this.#state = state;
    if (this.#spots.length !== state.seats.length) {
      this.#spots = duelSpots(state.seats);
      this.framing = framingOf(this.#spots);
    }
    this.#pieces.show(
      this.#spots.map((spot) => ({
        ...spot,
        y: 0,
        yaw: -spot.x * 0.012,
        size: 1.06,
        isLying: isEarly(state, spot.seat),
      })),
      false,
    );
  }

  update(frame: Frame): void {
    const state = this.#state;
    if (!state) return;
    this.#timeS += frame.dtS;
    for (const event of this.#events.splice(0)) this.#play(event, frame.isReduced);
    if (this.#hopper !== undefined && this.#timeS < this.#hopUntilS)
      this.#pieces.hop(this.#hopper, HOPS.height);
    this.#flagHeight = frame.isReduced
      ? Number(!isSignalled(state))
      : nextFlag(this.#flagHeight, isSignalled(state), frame.dtS);
    this.#flag.update(this.#flagHeight, this.#timeS, frame.isReduced);
    this.#shades.begin();
    this.#shades.add(0, 0, FLAG_Z, 6, 4.6);
    this.#pieces.update(frame, this.#shades);
    this.#shades.end();
    this.#rings.update(frame.dtS);
    this.#placeCrown(state, frame);
  }

  footOf(seat: Seat, into: Vector3): number {
    return this.#pieces.footOf(seat, into);
  }

  dispose(): void {
    for (const part of [this.#ground, this.#shades, this.#flag, this.#rings]) part.dispose();
    disposeToys(this.#props);
  }

  #play(event: DuelEvent, isReduced: boolean): void {
    switch (event.type) {
      case 'press':
        if (!isReduced) this.#pieces.hit(event.seat, 1);
        return;
      case 'won':
        this.#hopper = event.seat;
        this.#hopUntilS = this.#timeS + HOPS.count * 0.5 - 0.1;
        return;
      case 'signal':
        if (isReduced) this.#rings.launch(0, 0, FLAG_Z + 1.5);
    }
  }

  /** The winner of the last bout wears the crown. */
  #placeCrown({ decided }: DuelState, { dtS, isReduced }: Frame): void {
    const winner = decided.findLast((bout) => bout.winner !== undefined)?.winner;
    const piece = winner === undefined ? undefined : this.#pieces.find(winner);
    this.#crown.root.visible = piece !== undefined;
    if (!piece) return;
    this.#crownAt
      .set(0, piece.height * piece.body.scale.y + 0.12, 0)
      .applyEuler(piece.root.rotation);
    this.#crownAt.multiplyScalar(piece.root.scale.x).add(piece.root.position);
    this.#crown.update(winner, this.#crownAt, dtS, isReduced);
  }
}

function framingOf(spots: readonly DuelSpot[]): Framing {
  const half = Math.max(10.5, ...spots.map(({ x }) => Math.abs(x) + 1.2));
  return {
    pitchDeg: 22,
    points: [
      { x: -half, y: 0, z: 1.4 },
      { x: half, y: 0, z: 1.4 },
      { x: 0, y: 12.2, z: FLAG_Z },
    ],
    rect: { left: 0.02, right: 0.98, top: 0.05, bottom: 0.8 },
    tallRect: { left: 0.03, right: 0.97, top: 0.24, bottom: 0.74 },
  };
}
