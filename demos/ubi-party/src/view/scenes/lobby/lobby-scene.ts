import { Group, type Vector3 } from 'three';
import type { Player, Seat } from '../../../sim/index.ts';
import type { Framing } from '../../camera/camera-rig.ts';
import { ContactShades, GroundShade } from '../../light/ground-shade.ts';
import { HOURS } from '../../light/hours.ts';
import type { PieceKit } from '../../pieces/piece-kit.ts';
import { StandingPieces, yawOf } from '../../pieces/standing-pieces.ts';
import { disposeToys } from '../../toys/toy-box.ts';
import type { Frame, SceneView } from '../scene-view.ts';
import { lobbyPlan, lobbySize, lobbySpot, type LobbyPlan } from './lobby-spots.ts';
import { buildLobbyMarbles, buildLobbyToys, shadeMarbles, shadeToys } from './lobby-toys.ts';

/** A slow drift, degrees and seconds. */
const DRIFT = { deg: 2, periodS: 40 } as const;

/** The table where players gather, with the toys of all games. */
export class LobbyScene implements SceneView<{ kind: 'lobby'; players: readonly Player[] }> {
  readonly root = new Group();
  readonly hour = 'lobby';
  readonly reach = 26;
  readonly zoom = 1;
  framing: Framing = framingOf(lobbyPlan(0));
  swayDeg = 0;
  readonly #pieces: StandingPieces;
  readonly #ground: GroundShade;
  readonly #shades: ContactShades;
  readonly #toys: Group;
  readonly #marbles: Group;
  #plan: LobbyPlan | undefined;
  #timeS = 0;

  constructor(kit: PieceKit) {
    this.#ground = new GroundShade(this.root, HOURS.lobby);
    this.#shades = new ContactShades(this.root, HOURS.lobby, 48);
    this.#pieces = new StandingPieces(this.root, kit, 'table');
    this.#toys = buildLobbyToys(kit.paints);
    this.#marbles = buildLobbyMarbles(kit.paints);
    this.root.add(this.#toys, this.#marbles);
  }

  show({ players }: { players: readonly Player[] }): void {
    const plan = lobbyPlan(Math.max(0, ...players.map(({ seat }) => seat)));
    if (plan !== this.#plan) this.#lay(plan);
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

  footOf(seat: Seat, into: Vector3): boolean {
    return this.#pieces.footOf(seat, into);
  }

  dispose(): void {
    this.#ground.dispose();
    this.#shades.dispose();
    disposeToys(this.#toys);
    disposeToys(this.#marbles);
  }

  #lay(plan: LobbyPlan): void {
    this.#plan = plan;
    this.framing = framingOf(plan);
    const { depth } = lobbySize(plan);
    this.#toys.position.z = -depth;
    this.#toys.scale.setScalar(toysSize(plan));
    // With more rows they would lie before letters
    this.#marbles.visible = plan.rows === 2;
  }
}

/** The toys grow with the table, but not as much: pieces have the room. */
function toysSize(plan: LobbyPlan): number {
  return Math.min(1.2, lobbySize(plan).half / 7);
}

/** The left column is for the code, the bottom edge for the games. */
function framingOf(plan: LobbyPlan): Framing {
  const { half, depth } = lobbySize(plan);
  const size = toysSize(plan);
  return {
    pitchDeg: 27,
    points: [
      { x: -half - 0.3, y: 0, z: 0.8 },
      { x: half + 0.3, y: 0, z: 0.8 },
      { x: -half, y: 3, z: -depth },
      { x: half, y: 3, z: -depth },
      { x: 0, y: 4.6 * size, z: -depth - 5 * size },
    ],
    rect: { left: 0.345, right: 0.955, top: 0.1, bottom: 0.765 },
  };
}
