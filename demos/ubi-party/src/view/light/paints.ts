import {
  DataTexture,
  EquirectangularReflectionMapping,
  FloatType,
  MeshStandardMaterial,
  RGBAFormat,
  type ColorRepresentation,
} from 'three';

/** Finish of a surface. */
export type Finish = 'matte' | 'marble' | 'lacquer' | 'gold';
const FINISHES = {
  matte: { roughness: 0.7, shine: 0 },
  marble: { roughness: 0.3, shine: 0.25 },
  lacquer: { roughness: 0.12, shine: 0.16 },
  gold: { roughness: 0.32, shine: 0.4 },
} as const satisfies Record<Finish, { roughness: number; shine: number }>;

/** Materials by colour and finish: each is made once, and shared. */
export class Paints {
  readonly #room = softRoom();
  readonly #materials = new Map<string, MeshStandardMaterial>();

  of(colour: ColorRepresentation, finish: Finish = 'matte'): MeshStandardMaterial {
    const key = `${String(colour)} ${finish}`;
    let material = this.#materials.get(key);
    if (!material) {
      const { roughness, shine } = FINISHES[finish];
      material = new MeshStandardMaterial({
        color: colour,
        roughness,
        metalness: 0,
        envMap: shine > 0 ? this.#room : null,
        envMapIntensity: shine,
      });
      this.#materials.set(key, material);
    }
    return material;
  }

  /** One of its own, white, for instances that have their own colours. Whoever takes it disposes it. */
  instanced(finish: Finish): MeshStandardMaterial {
    return this.of('#ffffff', finish).clone();
  }

  dispose(): void {
    for (const material of this.#materials.values()) material.dispose();
    this.#room.dispose();
  }
}

const [WIDTH, HEIGHT] = [64, 32];

/** Environment map for marbles and lacquer: a room with one large soft window at the upper left. */
function softRoom(): DataTexture {
  const data = new Float32Array(WIDTH * HEIGHT * 4);
  for (let index = 0; index < WIDTH * HEIGHT; index += 1) {
    const [u, v] = [(index % WIDTH) / WIDTH, Math.floor(index / WIDTH) / HEIGHT];
    const window = Math.max(0, 1 - Math.hypot((u - 0.68) * 5, (v - 0.72) * 4));
    const light = 0.25 + 0.75 * v + window * 5;
    data.set([light, light * 0.98, light * 0.94, 1], index * 4);
  }
  const texture = new DataTexture(data, WIDTH, HEIGHT, RGBAFormat, FloatType);
  texture.mapping = EquirectangularReflectionMapping;
  texture.needsUpdate = true;
  return texture;
}
