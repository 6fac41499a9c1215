import { Group, type Vector3 } from 'three';
import type { Seat } from '../../../sim/index.ts';
import type { Framing } from '../../camera/camera-rig.ts';
import { ContactShades, GroundShade } from '../../light/ground-shade.ts';
import { HOURS } from '../../light/hours.ts';
import type { PieceKit } from '../../pieces/piece-kit.ts';
import { StandingPieces, yawOf } from '../../pieces/standing-pieces.ts';
import type { Scene } from '../../stage.ts';
import { disposeToys, placer } from '../../toys/toy-box.ts';
import { buildBlock } from '../../toys/turned.ts';
import type { Frame, SceneView } from '../scene-view.ts';

/** A table of games reaches so far to all sides, units. */
const HALF = 10;

/** Mats under the pieces at the left and at the right, units; no piece stands between. */
const MAT = { x: 6.8, z: 3.4, width: 8.2, depth: 9.6, height: 0.16 } as const;

/** Pieces on a bare table: the picture of games without a scene of their own. */
export class PiecesScene implements SceneView<Extract<Scene, { kind: 'pieces' }>> {
  readonly root = new Group();
  readonly hour = 'lobby';
  readonly reach = 26;
  readonly zoom = 1;
  readonly swayDeg = 0;
  readonly framing: Framing = {
    pitchDeg: 30,
    points: [
      { x: -HALF - 1, y: 0, z: HALF * 0.75 },
      { x: HALF + 1, y: 0, z: HALF * 0.75 },
      { x: -HALF, y: 2, z: -HALF * 0.7 },
      { x: HALF, y: 2, z: -HALF * 0.7 },
    ],
    rect: { left: 0.06, right: 0.94, top: 0.34, bottom: 0.79 },
    tallRect: { left: 0.03, right: 0.97, top: 0.42, bottom: 0.78 },
  };
  readonly #pieces: StandingPieces;
  readonly #ground: GroundShade;
  readonly #shades: ContactShades;
  readonly #mats = new Group();

  constructor(kit: PieceKit) {
    this.#ground = new GroundShade(this.root, HOURS.lobby);
    this.#shades = new ContactShades(this.root, HOURS.lobby, 48);
    this.#pieces = new StandingPieces(this.root, kit, 'foot');
    const add = placer(this.#mats, kit.paints);
    for (const side of [-1, 1])
      add(buildBlock(MAT.width, MAT.height, MAT.depth, 0.1), '#fbeed3', [
        side * MAT.x,
        -0.06,
        MAT.z,
      ]);
    this.root.add(this.#mats);
  }

  show({ pieces, hasSides }: Extract<Scene, { kind: 'pieces' }>): void {
    this.#mats.visible = hasSides;
    // Many stand closer: they are smaller
    const size = pieces.length > 12 ? 0.7 : 1.06;
    this.#pieces.show(
      pieces.map(({ seat, x, y, isOut }) => ({
        seat,
        x,
        y: 0,
        z: -y * 0.7,
        yaw: yawOf(seat),
        size,
        isLying: isOut,
      })),
      false,
    );
  }

  update(frame: Frame): void {
    this.#shades.begin();
    this.#pieces.update(frame, this.#shades);
    this.#shades.end();
  }

  footOf(seat: Seat, into: Vector3): number {
    return this.#pieces.footOf(seat, into);
  }

  dispose(): void {
    this.#ground.dispose();
    this.#shades.dispose();
    disposeToys(this.#mats);
  }
}
