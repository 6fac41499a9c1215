import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DynamicDrawUsage,
  LineBasicMaterial,
  LineSegments,
} from 'three';
import type { Point } from '../space-things.ts';

/** Lines of any colour in one draw call. */
export class LineBatch {
  readonly mesh = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
  readonly #color = new Color();
  #positions = new Float32Array(0);
  #colors = new Float32Array(0);
  #count = 0;

  constructor() {
    this.mesh.material.vertexColors = true;
    this.mesh.frustumCulled = false;
  }

  begin(): void {
    this.#count = 0;
  }

  add(from: Point, to: Point, color: string): void {
    this.#grow(this.#count + 2);
    this.#color.setStyle(color);
    for (const [x, y, z] of [from, to]) {
      const at = this.#count * 3;
      this.#positions.set([x, y, z], at);
      this.#colors.set([this.#color.r, this.#color.g, this.#color.b], at);
      this.#count += 1;
    }
  }

  end(): void {
    const { geometry } = this.mesh;
    for (const name of ['position', 'color']) {
      const attribute = geometry.getAttribute(name) as BufferAttribute | undefined;
      if (attribute) attribute.needsUpdate = true;
    }
    geometry.setDrawRange(0, this.#count);
    this.mesh.visible = this.#count > 0;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  /** GPU buffers cannot grow: replace it by a larger one. */
  #grow(count: number): void {
    if (this.#positions.length >= count * 3) return;
    const length = Math.max(256, 2 ** Math.ceil(Math.log2(count))) * 3;
    const positions = new Float32Array(length);
    const colors = new Float32Array(length);
    positions.set(this.#positions);
    colors.set(this.#colors);
    this.#positions = positions;
    this.#colors = colors;
    this.mesh.geometry.dispose();
    const attribute = (array: Float32Array): BufferAttribute =>
      new BufferAttribute(array, 3).setUsage(DynamicDrawUsage);
    this.mesh.geometry.setAttribute('position', attribute(positions));
    this.mesh.geometry.setAttribute('color', attribute(colors));
  }
}
