import { Color, DirectionalLight, HemisphereLight, type Group } from 'three';
import type { Quality } from '../quality/quality.ts';
import type { Hour } from './hours.ts';

/** Texels along the side of the shadow map; none at the lowest level. */
const MAP_SIZE: Readonly<Record<Quality, number>> = { low: 0, middle: 1024, high: 2048 };
/** Units over which the edge of a shadow is soft. */
const SOFTNESS = 0.55;
const DISTANCE = 60;

/** One warm key light with soft shadows, and a weak cool sky with a warm bounce. */
export class LightRig {
  readonly key = new DirectionalLight();
  readonly sky = new HemisphereLight();
  #reach = 20;
  #quality: Quality = 'high';

  constructor(root: Group) {
    root.add(this.key, this.key.target, this.sky);
    this.key.shadow.bias = -0.0008;
  }

  /** @param reach units from the middle in which things have shadows */
  light(hour: Hour, reach: number): void {
    this.key.color = new Color(hour.key.colour);
    this.key.intensity = hour.key.intensity;
    this.key.position.set(...hour.key.from).setLength(DISTANCE);
    this.sky.color = new Color(hour.sky.colour);
    this.sky.groundColor = new Color(hour.sky.bounce);
    this.sky.intensity = hour.sky.intensity;
    this.#reach = reach;
    this.#fit();
  }

  setQuality(quality: Quality): void {
    if (quality === this.#quality) return;
    this.#quality = quality;
    this.#fit();
  }

  dispose(): void {
    this.key.dispose();
    this.sky.dispose();
  }

  #fit(): void {
    const { shadow } = this.key;
    const size = MAP_SIZE[this.#quality];
    this.key.castShadow = size > 0;
    if (size === 0) return;
    const { camera } = shadow;
    [camera.left, camera.right] = [-this.#reach, this.#reach];
    [camera.bottom, camera.top] = [-this.#reach, this.#reach];
    [camera.near, camera.far] = [DISTANCE - this.#reach - 10, DISTANCE + this.#reach + 10];
    camera.updateProjectionMatrix();
    if (shadow.mapSize.x !== size) {
      shadow.mapSize.set(size, size);
      shadow.map?.dispose();
      shadow.map = null;
    }
    // A texel is larger where the reach is: what slopes would be striped by its own shadow
    shadow.normalBias = Math.max(0.03, (this.#reach * 2 * 1.8) / size);
    shadow.radius = (SOFTNESS * size) / (this.#reach * 2) / 2;
  }
}
