import {
  DataTexture,
  InstancedMesh,
  LinearFilter,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  RGBAFormat,
  ShadowMaterial,
  type Group,
} from 'three';
import type { Hour } from './hours.ts';

/** Darkening of the drawn ground: the shadows of the key light. */
export class GroundShade {
  readonly #material: ShadowMaterial;
  readonly #mesh: Mesh;

  constructor(root: Group, { shade }: Hour, size = 160) {
    this.#material = new ShadowMaterial({ color: shade.colour, opacity: shade.opacity });
    const geometry = new PlaneGeometry(size, size).rotateX(-Math.PI / 2);
    this.#mesh = new Mesh(geometry, this.#material);
    this.#mesh.receiveShadow = true;
    this.#mesh.renderOrder = -2;
    root.add(this.#mesh);
  }

  dispose(): void {
    this.#mesh.geometry.dispose();
    this.#material.dispose();
  }
}

const TEXELS = 64;

/** A round shade that fades to its edge. */
function softDisc(): DataTexture {
  const data = new Uint8Array(TEXELS * TEXELS * 4);
  for (let index = 0; index < TEXELS * TEXELS; index += 1) {
    const x = ((index % TEXELS) + 0.5) / TEXELS - 0.5;
    const y = (Math.floor(index / TEXELS) + 0.5) / TEXELS - 0.5;
    const share = Math.max(0, 1 - Math.hypot(x, y) * 2);
    data.set([255, 255, 255, Math.round(255 * share * share * (3 - 2 * share))], index * 4);
  }
  const texture = new DataTexture(data, TEXELS, TEXELS, RGBAFormat);
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** Contact shade under things that stand: dark spots, also on devices that draw no shadows. */
export class ContactShades {
  readonly #material: MeshBasicMaterial;
  readonly #mesh: InstancedMesh;
  readonly #matrix = new Matrix4();
  readonly #most: number;
  #count = 0;

  constructor(root: Group, { shade }: Hour, most: number, opacity = 0.5) {
    this.#most = most;
    this.#material = new MeshBasicMaterial({
      color: shade.colour,
      opacity,
      map: softDisc(),
      transparent: true,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -2,
      polygonOffsetUnits: -2,
    });
    this.#mesh = new InstancedMesh(
      new PlaneGeometry(1, 1).rotateX(-Math.PI / 2),
      this.#material,
      most,
    );
    this.#mesh.frustumCulled = false;
    this.#mesh.renderOrder = -1;
    root.add(this.#mesh);
  }

  /** Before the spots of a frame. */
  begin(): void {
    this.#count = 0;
  }

  /** Width and depth in units. */
  add(x: number, y: number, z: number, width: number, depth = width): void {
    if (this.#count >= this.#most) return;
    this.#matrix.makeScale(width, 1, depth).setPosition(x, y + 0.015, z);
    this.#mesh.setMatrixAt(this.#count, this.#matrix);
    this.#count += 1;
  }

  end(): void {
    this.#mesh.count = this.#count;
    this.#mesh.instanceMatrix.needsUpdate = true;
  }

  dispose(): void {
    this.#mesh.dispose();
    this.#mesh.geometry.dispose();
    this.#material.map?.dispose();
    this.#material.dispose();
  }
}
