import { Group, type Vector3 } from 'three';

import { MAX_SEATS, type Seat } from '../../../sim/index.ts';
import type { Framing } from '../../camera/camera-rig.ts';
import { ContactShades, GroundShade } from '../../light/ground-shade.ts';
import { HOURS } from '../../light/hours.ts';
import type { Paints } from '../../light/paints.ts';
import { scatter } from '../../motion/motion.ts';
import type { PieceKit } from '../../pieces/piece-kit.ts';
import { StandingPieces, yawOf } from '../../pieces/standing-pieces.ts';
import type { Scene } from '../../stage.ts';
import {
  buildArch,
  buildMarble,
  buildRamp,
  placer,
  WOOD,
  disposeToys,
} from '../../toys/toy-box.ts';
import { buildBlock, buildCone, buildCylinder } from '../../toys/turned.ts';
import type { Frame, SceneView } from '../scene-view.ts';

/** Number of rows and distance between pieces on a table, units. */
interface LobbyPlan {
  readonly seats: number;
  readonly rows: number;
  readonly columns: number;
  readonly column: number;
  /** Deep enough for a name between two rows. */
  readonly row: number;
  /** Of a piece: the fewer there are, the larger. */
  readonly size: number;
}

const PLANS: readonly LobbyPlan[] = [
  { seats: 8, rows: 2, columns: 4, column: 3.5, row: 5.8, size: 1.34 },
  { seats: 18, rows: 3, columns: 6, column: 3.2, row: 7, size: 1.16 },
  { seats: MAX_SEATS, rows: 4, columns: 8, column: 2.95, row: 7.2, size: 1.04 },
];

/** The smallest table for the highest seat that is taken: who sits keeps the place until the table is full. */
export function lobbyPlan(highest: Seat): LobbyPlan {
  return PLANS.find(({ seats }) => highest < seats) ?? PLANS.at(-1)!;
}

/** Position of a seat: the front row is filled first, rows stand in the gaps of those before them. */
export function lobbySpot(seat: Seat, plan: LobbyPlan): { readonly x: number; readonly z: number } {
  const row = Math.floor(seat / plan.columns);
  const column = seat % plan.columns;
  const shift = row % 2 === 0 ? -0.22 : 0.22;
  return {
    x: (column - (plan.columns - 1) / 2 + shift) * plan.column + (scatter(seat, 1) - 0.5) * 0.3,
    z: -row * plan.row + (scatter(seat, 2) - 0.5) * 0.5,
  };
}

/** Half of the width, and the depth, that pieces cover. */
export function lobbySize(plan: LobbyPlan): { readonly half: number; readonly depth: number } {
  return { half: (plan.columns / 2) * plan.column, depth: (plan.rows - 1) * plan.row };
}

/** The toys behind the players, on a strip of 16 units; the back row stands at z = 0. */
function buildLobbyToys(paints: Paints): Group {
  const root = new Group();
  const add = placer(root, paints);
  add(buildCylinder(0.95, 3.9, 0.1), '#3f6fc0', [-5.7, 0, -3.4]);
  add(buildMarble(1), '#f2a71e', [-5.7, 3.86, -3.4], { finish: 'marble' });
  add(buildArch(5, 4.9, 1.6, 1.35), WOOD, [0.1, 0, -5.6], { turn: 0.06 });
  add(buildRamp(4.2, 2.2, 1.6), '#f191b8', [4.3, 0, -5.6], { turn: 0.12 });
  add(buildBlock(2.3, 2.5, 2.3, 0.12), '#e8843c', [6.9, 0, -4.4], { turn: 0.14 });
  add(buildBlock(2.3, 2.3, 2.3, 0.12), WOOD, [9.4, 0, -5.4], { turn: 0.1 });
  add(buildCone(1.35, 2.6, 0.12), '#3aa66f', [9.4, 2.3, -5.4]);
  add(buildBlock(2, 2, 2, 0.12), '#e9dcc2', [12, 0, -6.6], { turn: -0.2 });
  return root;
}

const SHADES: readonly (readonly [x: number, z: number, width: number, depth: number])[] = [
  [-5.7, -3.4, 3.4, 2.8],
  [-1.6, -5.6, 3, 3],
  [2, -5.6, 3, 3],
  [4.3, -5.6, 6, 3],
  [6.9, -4.4, 4, 3.6],
  [9.4, -5.4, 4, 3.6],
];

function shadeToys(toys: Group, shades: ContactShades): void {
  const { position, scale } = toys;
  for (const [x, z, width, depth] of SHADES) {
    const size = scale.x;
    shades.add(position.x + x * size, 0, position.z + z * size, width * size, depth * size);
  }
}

const MARBLES = [
  { colour: '#e8452f', radius: 0.5, x: -4.7, z: -3.1 },
  { colour: '#0e6e78', radius: 0.42, x: -0.4, z: -3 },
  { colour: '#efe3cb', radius: 0.42, x: 7.5, z: -1.6 },
] as const;

/** Marbles between the rows. */
function buildLobbyMarbles(paints: Paints): Group {
  const root = new Group();
  const add = placer(root, paints);
  for (const { colour, radius, x, z } of MARBLES)
    add(buildMarble(radius), colour, [x, 0, z], { finish: 'marble' });
  return root;
}

function shadeMarbles(root: Group, shades: ContactShades): void {
  for (const { x, z, radius } of MARBLES)
    shades.add(root.position.x + x, 0, z, radius * 2.2, radius * 1.8);
}

/** A slow drift, degrees and seconds. */
const DRIFT = { deg: 2, periodS: 40 } as const;

type LobbyShown = Extract<Scene, { kind: 'lobby' }>;

/** The table where players gather, with the toys of all games. */
export class LobbyScene implements SceneView<LobbyShown> {
  readonly root = new Group();
  readonly hour = 'lobby';
  readonly reach = 26;
  readonly zoom = 1;
  framing: Framing = framingOf(lobbyPlan(0), 'join');
  swayDeg = 0;
  readonly #pieces: StandingPieces;
  readonly #ground: GroundShade;
  readonly #shades: ContactShades;
  readonly #toys: Group;
  readonly #marbles: Group;
  #plan: LobbyPlan | undefined;
  #words: LobbyShown['words'] = 'join';
  #timeS = 0;

  constructor(kit: PieceKit) {
    this.#ground = new GroundShade(this.root, HOURS.lobby);
    this.#shades = new ContactShades(this.root, HOURS.lobby, 48);
    this.#pieces = new StandingPieces(this.root, kit, 'table');
    this.#toys = buildLobbyToys(kit.paints);
    this.#marbles = buildLobbyMarbles(kit.paints);
    this.root.add(this.#toys, this.#marbles);
  }

  show({ players, words }: LobbyShown): void {
    const plan = lobbyPlan(Math.max(0, ...players.map(({ seat }) => seat)));
    if (plan !== this.#plan || words !== this.#words) this.#lay(plan, words);
    this.#pieces.show(
      players.map(({ seat, awaySinceMs }) => ({
        seat,
        ...lobbySpot(seat, plan),
        y: 0,
        yaw: yawOf(seat),
        size: plan.size,
        isLying: awaySinceMs !== undefined,
      })),
      true,
    );
  }

  update(frame: Frame): void {
    this.#timeS += frame.dtS;
    this.swayDeg = DRIFT.deg * Math.sin((this.#timeS / DRIFT.periodS) * Math.PI * 2);
    this.#shades.begin();
    shadeToys(this.#toys, this.#shades);
    if (this.#marbles.visible) shadeMarbles(this.#marbles, this.#shades);
    this.#pieces.update(frame, this.#shades);
    this.#shades.end();
  }

  footOf(seat: Seat, into: Vector3): number {
    return this.#pieces.footOf(seat, into);
  }

  dispose(): void {
    this.#ground.dispose();
    this.#shades.dispose();
    disposeToys(this.#toys);
    disposeToys(this.#marbles);
  }

  #lay(plan: LobbyPlan, words: LobbyShown['words']): void {
    this.#plan = plan;
    this.#words = words;
    this.framing = framingOf(plan, words);
    const { depth } = lobbySize(plan);
    this.#toys.position.z = -depth;
    this.#toys.scale.setScalar(toysSize(plan));
    // With more rows they would lie before letters
    this.#marbles.visible = plan.rows === 2;
  }
}

/** The toys grow with the table, but not as much: pieces have the room. */
function toysSize(plan: LobbyPlan): number {
  // Behind four rows they would take the height
  return plan.rows > 3 ? 0.85 : Math.min(1.2, lobbySize(plan).half / 7);
}

/** Words stand at the left; how to join also has the games at the bottom edge. On a high picture they stand on top. */
const RECTS = {
  join: {
    rect: { left: 0.345, right: 0.955, top: 0.1, bottom: 0.765 },
    tallRect: { left: 0.05, right: 0.95, top: 0.5, bottom: 0.76 },
  },
  explanation: {
    rect: { left: 0.45, right: 0.965, top: 0.12, bottom: 0.9 },
    tallRect: { left: 0.05, right: 0.95, top: 0.6, bottom: 0.94 },
  },
} as const;

function framingOf(plan: LobbyPlan, words: LobbyShown['words']): Framing {
  const { half, depth } = lobbySize(plan);
  const size = toysSize(plan);
  return {
    pitchDeg: 27,
    mostPitchDeg: 38,
    points: [
      { x: -half - 0.3, y: 0, z: 0.8 },
      { x: half + 0.3, y: 0, z: 0.8 },
      { x: -half, y: 3, z: -depth },
      { x: half, y: 3, z: -depth },
      { x: 0, y: 4.6 * size, z: -depth - 5 * size },
    ],
    ...RECTS[words],
  };
}
