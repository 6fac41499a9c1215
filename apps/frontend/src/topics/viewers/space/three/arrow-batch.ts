import {
  Color,
  InstancedMesh,
  LatheGeometry,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  SphereGeometry,
  Vector2,
  Vector3,
  type BufferGeometry,
} from 'three';
import type { Point } from '../space-things.ts';

/** Outline of an arrow of length 1 along y; radii are scaled, too. */
const OUTLINE = [
  [0, 0],
  [1, 0],
  [1, 0.82],
  [2.6, 0.82],
  [0, 1],
].map(([x, y]) => new Vector2(x, y));
const AROUND = 10;
const Y = new Vector3(0, 1, 0);

/** Arrows or dots of any colour in one draw call. */
export class Batch {
  readonly mesh: InstancedMesh<BufferGeometry, MeshBasicMaterial>;
  readonly #color = new Color();
  readonly #matrix = new Matrix4();
  #count = 0;

  private constructor(geometry: BufferGeometry, most: number) {
    this.mesh = new InstancedMesh(geometry, new MeshBasicMaterial(), most);
    this.mesh.frustumCulled = false;
  }

  static ofArrows(most: number): Batch {
    return new Batch(new LatheGeometry(OUTLINE, AROUND), most);
  }

  static ofDots(most: number): Batch {
    return new Batch(new SphereGeometry(1, AROUND, AROUND), most);
  }

  begin(): void {
    this.#count = 0;
  }

  /** @returns its index for `tipOf`; -1 when its length is zero */
  addArrow(from: Point, along: Point, radius: number, color: string): number {
    const direction = new Vector3(...along);
    const length = direction.length();
    if (!(length > 0) || !Number.isFinite(length)) return -1;
    const turned = new Quaternion().setFromUnitVectors(Y, direction.divideScalar(length));
    const wide = Math.min(radius, length / 8);
    this.#matrix.compose(new Vector3(...from), turned, new Vector3(wide, length, wide));
    return this.#push(color);
  }

  addDot(at: Point, radius: number, color: string): void {
    this.#matrix.makeScale(radius, radius, radius).setPosition(...at);
    this.#push(color);
  }

  end(): void {
    this.mesh.count = this.#count;
    this.mesh.visible = this.#count > 0;
    this.mesh.instanceMatrix.needsUpdate = true;
    if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
  }

  /** Position slightly beyond the tip of an arrow. */
  tipOf(index: number): Vector3 {
    this.mesh.getMatrixAt(index, this.#matrix);
    return new Vector3(0, 1.08, 0).applyMatrix4(this.#matrix);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.mesh.dispose();
  }

  #push(color: string): number {
    const index = this.#count++;
    this.mesh.setMatrixAt(index, this.#matrix);
    this.mesh.setColorAt(index, this.#color.setStyle(color));
    return index;
  }
}
