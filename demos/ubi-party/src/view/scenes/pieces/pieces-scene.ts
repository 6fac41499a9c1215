import { Group, type Vector3 } from 'three';
import type { Seat, TablePiece } from '../../../sim/index.ts';
import type { Framing } from '../../camera/camera-rig.ts';
import { ContactShades, GroundShade } from '../../light/ground-shade.ts';
import { HOURS } from '../../light/hours.ts';
import type { PieceKit } from '../../pieces/piece-kit.ts';
import { StandingPieces, yawOf } from '../../pieces/standing-pieces.ts';
import type { Frame, SceneView } from '../scene-view.ts';

/** A table of games reaches so far to all sides, units. */
const HALF = 10;

/** Pieces on a bare table: the picture of games without a scene of their own. */
export class PiecesScene implements SceneView<{
  kind: 'pieces';
  pieces: readonly TablePiece[];
}> {
  readonly root = new Group();
  readonly hour = 'lobby';
  readonly reach = 26;
  readonly zoom = 1;
  readonly swayDeg = 0;
  readonly framing: Framing = {
    pitchDeg: 30,
    points: [
      { x: -HALF, y: 0, z: HALF * 0.7 },
      { x: HALF, y: 0, z: HALF * 0.7 },
      { x: -HALF, y: 2, z: -HALF * 0.7 },
      { x: HALF, y: 2, z: -HALF * 0.7 },
    ],
    rect: { left: 0.1, right: 0.9, top: 0.32, bottom: 0.8 },
  };
  readonly #pieces: StandingPieces;
  readonly #ground: GroundShade;
  readonly #shades: ContactShades;

  constructor(kit: PieceKit) {
    this.#ground = new GroundShade(this.root, HOURS.lobby);
    this.#shades = new ContactShades(this.root, HOURS.lobby, 48);
    this.#pieces = new StandingPieces(this.root, kit, 'foot');
  }

  show({ pieces }: { pieces: readonly TablePiece[] }): void {
    // Many stand closer: they are smaller
    const size = pieces.length > 12 ? 0.7 : 1.06;
    this.#pieces.show(
      pieces.map(({ seat, x, y, isOut }) => ({
        ...{ seat, x, y: 0, z: -y * 0.7, yaw: yawOf(seat), size, isLying: isOut },
      })),
      false,
    );
  }

  update(frame: Frame): void {
    this.#shades.begin();
    this.#pieces.update(frame, this.#shades);
    this.#shades.end();
  }

  footOf(seat: Seat, into: Vector3): boolean {
    return this.#pieces.footOf(seat, into);
  }

  dispose(): void {
    this.#ground.dispose();
    this.#shades.dispose();
  }
}
