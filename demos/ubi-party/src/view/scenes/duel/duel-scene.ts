import { Group, Vector3 } from 'three';

import { isSignalled, type DuelState, type Seat } from '../../../sim/index.ts';
import type { Framing } from '../../camera/camera-rig.ts';
import { ContactShades, GroundShade } from '../../light/ground-shade.ts';
import { HOURS } from '../../light/hours.ts';
import type { Paints } from '../../light/paints.ts';
import { PulseRings } from '../../motion/effects.ts';
import { CrownMover } from '../../pieces/crown-mover.ts';
import type { PieceKit } from '../../pieces/piece-kit.ts';
import { StandingPieces } from '../../pieces/standing-pieces.ts';
import { buildArch, buildMarble, placer, WOOD, disposeToys } from '../../toys/toy-box.ts';
import { buildBlock, buildCone, buildCylinder } from '../../toys/turned.ts';
import type { Frame, SceneView } from '../scene-view.ts';
import { Flag } from './flag.ts';

/** An event of the duel. */
export type DuelEvent =
  | { readonly type: 'signal' }
  | { readonly type: 'press'; readonly seat: Seat }
  | { readonly type: 'won'; readonly seat: Seat };

/** Copy of the compared values of a state, which the game changes in place. */
interface DuelGlance {
  readonly step: number;
  readonly bouts: number;
  readonly isSignalled: boolean;
  readonly pressed: ReadonlySet<Seat>;
}

export function glanceAtDuel(state: DuelState): DuelGlance {
  return {
    step: state.step,
    bouts: state.decided.length,
    isSignalled: isSignalled(state),
    pressed: new Set(state.seats.filter((seat) => seat in state.bout.presses)),
  };
}

/** Events between two states of a round; none when the second is of an earlier time, as in a replay. */
export function duelEvents(before: DuelGlance, state: DuelState): DuelEvent[] {
  if (state.step < before.step) return [];
  const isNewBout = state.decided.length > before.bouts;
  const events: DuelEvent[] = [];
  if (isSignalled(state) && (isNewBout || !before.isSignalled)) events.push({ type: 'signal' });
  for (const seat of state.seats) {
    const wasPressed = !isNewBout && before.pressed.has(seat);
    if (seat in state.bout.presses && !wasPressed) events.push({ type: 'press', seat });
  }
  const winner = isNewBout ? state.decided.at(-1)?.winner : undefined;
  if (winner !== undefined) events.push({ type: 'won', seat: winner });
  return events;
}

/** Whether a player pressed before the flag fell: out until the next bout. */
export function isEarly({ bout }: DuelState, seat: Seat): boolean {
  const pressedAtMs = bout.presses[seat];
  return pressedAtMs !== undefined && pressedAtMs < bout.signalAtMs;
}

/** Seconds that the flag takes to fall, and to be raised again. */
const FALL_S = 0.2;
const RAISE_S = 0.6;

/** Height of the flag in the next frame, 0 to 1. It falls like a stone and is raised at constant speed. */
export function nextFlag(height: number, isFallen: boolean, dtS: number): number {
  if (!isFallen) return Math.min(1, height + dtS / RAISE_S);
  const fallenS = FALL_S * Math.sqrt(Math.max(0, 1 - height)) + dtS;
  return Math.max(0, 1 - (fallenS / FALL_S) ** 2);
}

/** A small town of blocks behind the duel, in colours that no player has. */
function buildDuelProps(paints: Paints): Group {
  const root = new Group();
  const add = placer(root, paints);
  add(buildArch(5.2, 5.4, 1.8, 1.3), WOOD, [-11.5, 0, -10.5], { turn: 0.25 });
  add(buildBlock(3, 3, 3, 0.14), '#d9a06b', [-16, 0, -9], { turn: 0.2 });
  add(buildBlock(2.1, 2.1, 2.1, 0.12), '#b9c7c4', [-16, 3, -9], { turn: -0.3 });
  add(buildCylinder(1.5, 4.4, 0.14), '#a9b8b8', [12, 0, -10.5]);
  add(buildCone(2.1, 2.6, 0.14), '#d9835f', [12, 4.4, -10.5]);
  add(buildBlock(3.4, 2.6, 2.6, 0.14), WOOD, [16.4, 0, -9.2], { turn: -0.24 });
  add(buildMarble(1.15), '#c9b38e', [16.4, 2.6, -9.2], { finish: 'marble' });
  add(buildMarble(0.6), '#b9c7c4', [-7.6, 0, -5.5], { finish: 'marble' });
  return root;
}

/** From so many on, there are two rows. */
const TWO_ROWS = 9;
const ROW_Z = 4.4;

interface DuelSpot {
  readonly seat: Seat;
  readonly x: number;
  readonly z: number;
}

/** One row, or two of which the second stands in the gaps of the first; the flag is behind them. */
export function duelSpots(seats: readonly Seat[]): DuelSpot[] {
  const rows = seats.length < TWO_ROWS ? 1 : 2;
  const perRow = Math.ceil(seats.length / rows);
  const gap = Math.max(2.5, Math.min(4, 20 / perRow));
  return seats.map((seat, index) => {
    const [row, column] = [Math.floor(index / perRow), index % perRow];
    const inRow = row === 0 ? perRow : seats.length - perRow;
    const offset = (perRow - inRow) % 2 === 0 && row === 1 ? gap / 2 : 0;
    return { seat, x: (column - (inRow - 1) / 2) * gap + offset, z: -row * ROW_Z };
  });
}

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
