import { Mesh, MeshBasicMaterial, RingGeometry, type Group } from 'three';
import { easeOut } from './ease.ts';

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
