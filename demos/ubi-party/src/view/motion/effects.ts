import {
  Color,
  Euler,
  InstancedMesh,
  Matrix4,
  Quaternion,
  Vector3,
  Mesh,
  MeshBasicMaterial,
  RingGeometry,
  type Group,
  type BufferGeometry,
  type Material,
} from 'three';

import { scatter, easeOut } from './motion.ts';

const GRAVITY = 22;

/** Initial state of a bit. */
interface BitStart {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly vx: number;
  readonly vy: number;
  readonly vz: number;
  readonly size: number;
  readonly lifeS: number;
}

/** Small things that fly and fall: one draw call for all. The newest replaces the oldest. */
export class FlyingBits {
  readonly mesh: InstancedMesh;
  readonly #most: number;
  readonly #at: Float32Array;
  readonly #speed: Float32Array;
  readonly #size: Float32Array;
  readonly #age: Float32Array;
  readonly #life: Float32Array;
  readonly #drag: number;
  #next = 0;
  readonly #matrix = new Matrix4();
  readonly #place = new Vector3();
  readonly #turn = new Quaternion();
  readonly #euler = new Euler();
  readonly #scale = new Vector3();
  readonly #colour = new Color();

  /** @param drag share of the speed that is lost per second: paper falls slowly */
  constructor(root: Group, geometry: BufferGeometry, material: Material, most: number, drag = 0) {
    this.#most = most;
    this.#drag = drag;
    this.#at = new Float32Array(most * 3);
    this.#speed = new Float32Array(most * 3);
    this.#size = new Float32Array(most);
    this.#age = new Float32Array(most).fill(1);
    this.#life = new Float32Array(most);
    this.mesh = new InstancedMesh(geometry, material, most);
    this.mesh.frustumCulled = false;
    this.mesh.castShadow = true;
    this.#colour.set('#ffffff');
    for (let index = 0; index < most; index += 1) this.mesh.setColorAt(index, this.#colour);
    this.mesh.visible = false;
    root.add(this.mesh);
  }

  launch(start: BitStart, colour?: string): void {
    const index = this.#next;
    this.#next = (index + 1) % this.#most;
    this.#at.set([start.x, start.y, start.z], index * 3);
    this.#speed.set([start.vx, start.vy, start.vz], index * 3);
    this.#size[index] = start.size;
    this.#age[index] = 0;
    this.#life[index] = start.lifeS;
    if (colour) {
      this.mesh.setColorAt(index, this.#colour.set(colour));
      this.mesh.instanceColor!.needsUpdate = true;
    }
  }

  /** @param ground height at which bits come to rest, units */
  update(dtS: number, ground: number): void {
    let isAny = false;
    for (let index = 0; index < this.#most; index += 1) {
      const share = this.#fly(index, dtS, ground);
      isAny ||= share > 0;
      this.#scale.setScalar(this.#size[index]! * share);
      this.#matrix.compose(this.#place, this.#turn, this.#scale);
      this.mesh.setMatrixAt(index, this.#matrix);
    }
    this.mesh.visible = isAny;
    this.mesh.instanceMatrix.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.dispose();
  }

  /** @returns its size as a share: it shrinks in the last fifth of its life */
  #fly(index: number, dtS: number, ground: number): number {
    const [at, speed] = [this.#at, this.#speed];
    const [x, y, z] = [index * 3, index * 3 + 1, index * 3 + 2];
    this.#age[index]! += dtS;
    const left = 1 - this.#age[index]! / Math.max(0.001, this.#life[index]!);
    if (left <= 0) return 0;
    speed[y]! -= GRAVITY * (1 - this.#drag * 0.85) * dtS;
    const kept = 1 - Math.min(1, this.#drag * 2.4 * dtS);
    for (const axis of [x, y, z]) {
      speed[axis]! *= kept;
      at[axis]! += speed[axis]! * dtS;
    }
    const isDown = at[y]! < ground + 0.05;
    if (isDown) {
      at[y] = ground + 0.05;
      speed[x]! *= 0.6;
      speed[z]! *= 0.6;
      speed[y] = Math.abs(speed[y]!) > 2 && this.#drag === 0 ? -speed[y]! * 0.3 : 0;
    }
    this.#place.set(at[x]!, at[y]!, at[z]!);
    // Bits of paper come to lie flat
    const turn = this.#age[index]! * (4 + 8 * scatter(index, 5));
    if (isDown && this.#drag > 0) this.#euler.set(-Math.PI / 2, 0, scatter(index, 4) * 6);
    else this.#euler.set(turn, turn * 0.7 + index, scatter(index, 4) * 6);
    this.#turn.setFromEuler(this.#euler);
    return Math.min(1, left * 5);
  }
}

const LASTS_S = 0.45;
const MOST = 6;

/** Rings that grow and vanish: what is left of chips with reduced motion. */
export class PulseRings {
  readonly #geometry = new RingGeometry(0.86, 1, 48).rotateX(-Math.PI / 2);
  readonly #rings: { readonly mesh: Mesh<RingGeometry, MeshBasicMaterial>; ageS: number }[];
  #next = 0;

  constructor(root: Group, colour: string) {
    this.#rings = Array.from({ length: MOST }, () => {
      const material = new MeshBasicMaterial({
        color: colour,
        transparent: true,
        depthWrite: false,
      });
      const mesh = new Mesh(this.#geometry, material);
      mesh.visible = false;
      root.add(mesh);
      return { mesh, ageS: LASTS_S };
    });
  }

  launch(x: number, y: number, z: number): void {
    const ring = this.#rings[this.#next]!;
    this.#next = (this.#next + 1) % MOST;
    ring.ageS = 0;
    ring.mesh.position.set(x, y + 0.03, z);
  }

  update(dtS: number): void {
    for (const ring of this.#rings) {
      ring.ageS += dtS;
      const share = ring.ageS / LASTS_S;
      ring.mesh.visible = share < 1;
      ring.mesh.scale.setScalar(0.6 + easeOut(share) * 1.6);
      ring.mesh.material.opacity = 1 - share;
    }
  }

  dispose(): void {
    this.#geometry.dispose();
    for (const { mesh } of this.#rings) mesh.material.dispose();
  }
}
