import { Group, type Vector3 } from 'three';
import type { Seat } from '../../../sim/index.ts';
import type { Framing } from '../../camera/camera-rig.ts';
import { ContactShades, GroundShade } from '../../light/ground-shade.ts';
import { HOURS } from '../../light/hours.ts';
import type { PieceKit } from '../../pieces/piece-kit.ts';
import { StandingPieces, yawOf } from '../../pieces/standing-pieces.ts';
import type { Scene } from '../../stage.ts';
import { disposeToys } from '../../toys/toy-box.ts';
import type { Frame, SceneView } from '../scene-view.ts';
import { lobbyPlan, lobbySize, lobbySpot, type LobbyPlan } from './lobby-spots.ts';
import { buildLobbyMarbles, buildLobbyToys, shadeMarbles, shadeToys } from './lobby-toys.ts';

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
