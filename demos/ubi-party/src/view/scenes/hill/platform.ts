import {
  ExtrudeGeometry,
  Shape,
  CircleGeometry,
  Color,
  Euler,
  InstancedMesh,
  Matrix4,
  Mesh,
  Quaternion,
  RingGeometry,
  Vector3,
  type BufferGeometry,
  type Group,
} from 'three';
import { toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';

import { MIDDLE_RADIUS, PLATFORM_RADIUS, RINGS } from '../../../sim/index.ts';
import type { Paints } from '../../light/paints.ts';
import { buildTurned } from '../../toys/turned.ts';
import {
  BLOCK_HEIGHT,
  DRUM_RADIUS,
  PLATFORM_Y,
  BLOCKS,
  blockPose,
  dangerOf,
  type BlockPose,
} from './platform-motion.ts';

const BEVEL = 0.07;
/** Between two blocks, units. */
const GAP = 0.05;

/** A block of a ring: its middle is the origin, outwards is +x, its top is level. */
function buildRingBlock(inner: number, outer: number, blocks: number): BufferGeometry {
  const half = Math.PI / blocks;
  const middle = (inner + outer) / 2;
  const [from, to] = [inner + GAP / 2, outer - GAP / 2];
  // The gap is as wide at the outer edge as at the inner one
  const [inset, outset] = [half - GAP / 2 / from, half - GAP / 2 / to];
  const shape = new Shape();
  shape.moveTo(Math.cos(-outset) * to, Math.sin(-outset) * to);
  shape.absarc(0, 0, to, -outset, outset, false);
  shape.lineTo(Math.cos(inset) * from, Math.sin(inset) * from);
  shape.absarc(0, 0, from, inset, -inset, true);
  const flat = new ExtrudeGeometry(shape, {
    depth: BLOCK_HEIGHT - BEVEL * 2,
    bevelSize: BEVEL,
    bevelOffset: -BEVEL,
    bevelThickness: BEVEL,
    bevelSegments: 3,
    curveSegments: 10,
  });
  flat.translate(-middle, 0, -BLOCK_HEIGHT / 2 + BEVEL).rotateX(-Math.PI / 2);
  const block = toCreasedNormals(flat, 0.5);
  flat.dispose();
  block.deleteAttribute('uv');
  return block;
}

/** The disc that stays, of radius 1: it is drawn as wide as it is. */
function buildDisc(radius: number): BufferGeometry {
  return buildTurned(
    [
      [0, -BLOCK_HEIGHT],
      [radius * 0.93, -BLOCK_HEIGHT],
      [radius, -BLOCK_HEIGHT * 0.6],
      [radius, 0],
      [0, 0],
    ],
    0.14,
    96,
  );
}

/** Base of the platform: a drum, and a neck that is as narrow at its top as the last of the disc. */
function buildDrum(): BufferGeometry {
  const radius = DRUM_RADIUS;
  return buildTurned(
    [
      [0, 0],
      [radius, 0],
      [radius, 1.1],
      [radius - 0.5, 1.3],
      [0, 1.3],
    ],
    0.12,
    72,
  );
}
function buildNeckOfHill(): BufferGeometry {
  const top = PLATFORM_Y - BLOCK_HEIGHT + 0.04;
  return buildTurned(
    [
      [0, 1.2],
      [5.6, 1.2],
      [5.3, 1.7],
      [1.1, top],
      [0, top],
    ],
    0.12,
    72,
  );
}

const DANGER = [new Color('#ef7a5e'), new Color('#f7cfc4')] as const;
const CALM = [new Color('#e9f4f4'), new Color('#d9e9ec')] as const;
/** Blocks on the table are in the shade of the hour: they differ from the ground. */
const FALLEN = new Color('#5a4f74');
const CORE = RINGS.at(-1)!.inner;

/** The platform: a disc that stays and shrinks at the end, and the rings of blocks round it that fall. */
export class Platform {
  readonly #rings: InstancedMesh[];
  readonly #disc: Mesh;
  readonly #middle: Mesh;
  readonly #line: Mesh;
  readonly #own: { dispose(): void }[] = [];
  readonly #pose: BlockPose = { out: 0, up: 0, tilt: 0, turn: 0, down: 0 };
  readonly #matrix = new Matrix4();
  readonly #place = new Vector3();
  readonly #turn = new Quaternion();
  readonly #euler = new Euler(0, 0, 0, 'YXZ');
  readonly #one = new Vector3(1, 1, 1);
  readonly #colour = new Color();

  constructor(root: Group, paints: Paints) {
    const lacquer = paints.of('#e9f4f4', 'lacquer');
    this.#rings = RINGS.map(({ inner }, ring) => {
      const outer = RINGS[ring - 1]?.inner ?? PLATFORM_RADIUS;
      const material = paints.instanced(ring === 0 ? 'matte' : 'lacquer');
      const geometry = buildRingBlock(inner, outer, BLOCKS[ring]!);
      const mesh = new InstancedMesh(geometry, material, BLOCKS[ring]!);
      mesh.frustumCulled = false;
      this.#own.push(material, geometry, mesh);
      return mesh;
    });
    this.#disc = this.#mesh(buildDisc(CORE - 0.02), lacquer);
    this.#middle = this.#mesh(
      new CircleGeometry(MIDDLE_RADIUS, 64).rotateX(-Math.PI / 2),
      paints.of('#f5cb3f', 'lacquer'),
    );
    this.#line = this.#mesh(
      new RingGeometry(3.05, 3.2, 96).rotateX(-Math.PI / 2),
      paints.of('#a7d3e3', 'lacquer'),
    );
    const drum = this.#mesh(buildDrum(), paints.of('#a53b30'));
    const neck = this.#mesh(buildNeckOfHill(), paints.of('#dfe8ec'));
    for (const mesh of [this.#disc, drum, neck, ...this.#rings]) mesh.castShadow = true;
    for (const mesh of [this.#disc, this.#middle, this.#line, drum, neck, ...this.#rings]) {
      mesh.receiveShadow = true;
      root.add(mesh);
    }
  }

  /** @param radius of what is left, units */
  update(step: number, radius: number, isReduced: boolean): void {
    const core = Math.min(1, radius / CORE);
    this.#disc.position.y = PLATFORM_Y;
    this.#disc.scale.set(core, 1, core);
    this.#line.position.y = PLATFORM_Y + 0.012;
    this.#line.visible = radius > 3.4;
    const middle = Math.min(1, (radius - 0.12) / MIDDLE_RADIUS);
    this.#middle.position.y = PLATFORM_Y + 0.016;
    this.#middle.scale.set(middle, 1, middle);
    for (const [ring, mesh] of this.#rings.entries()) this.#poseRing(ring, mesh, step, isReduced);
  }

  dispose(): void {
    for (const own of this.#own) own.dispose();
  }

  #poseRing(ring: number, mesh: InstancedMesh, step: number, isReduced: boolean): void {
    const count = BLOCKS[ring]!;
    const inner = RINGS[ring]!.inner;
    const middle = (inner + (RINGS[ring - 1]?.inner ?? PLATFORM_RADIUS)) / 2;
    const danger = dangerOf(ring, step);
    for (let block = 0; block < count; block += 1) {
      const pose = blockPose(ring, block, step, isReduced, this.#pose);
      // The gaps of two rings never meet
      const angle = ((block + 0.5 + ring * 0.31) / count) * Math.PI * 2;
      const away = middle + pose.out;
      this.#place.set(
        Math.cos(angle) * away,
        PLATFORM_Y - BLOCK_HEIGHT / 2 + pose.up,
        -Math.sin(angle) * away,
      );
      this.#euler.set(0, angle + pose.turn, -pose.tilt);
      this.#turn.setFromEuler(this.#euler);
      mesh.setMatrixAt(block, this.#matrix.compose(this.#place, this.#turn, this.#one));
      this.#colour.lerpColors(CALM[block % 2]!, DANGER[block % 2]!, danger);
      this.#colour.lerp(FALLEN, pose.down * 0.55);
      mesh.setColorAt(block, this.#colour);
    }
    mesh.instanceMatrix.needsUpdate = true;
    mesh.instanceColor!.needsUpdate = true;
  }

  #mesh(geometry: Mesh['geometry'], material: Mesh['material']): Mesh {
    this.#own.push(geometry);
    return new Mesh(geometry, material);
  }
}
