import { ShaderChunk, Color, DirectionalLight, HemisphereLight, type Group } from 'three';

import type { Quality } from '../quality/quality.ts';
import type { Hour } from './hours.ts';

/** Samples of the shadow map for a pixel: three.js takes five, whose noise is seen on a big screen. */
const SAMPLES = 14;

const SUM_OF_FIVE =
  /shadow = \(\s*(texture\( shadowMap, vec3\( shadowCoord\.xy \+ vogelDiskSample\( \d, 5, phi \) \* radius, shadowCoord\.z \) \)\s*\+?\s*){5}\) \* 0\.2;/;

const SUM_OF_MORE = `
  shadow = 0.0;
  for ( int index = 0; index < ${SAMPLES}; index ++ ) {
    shadow += texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( index, ${SAMPLES}, phi ) * radius, shadowCoord.z ) );
  }
  shadow /= ${SAMPLES}.0;`;

/** The shader part of three.js with more samples; the same part where it is written differently than known. */
export function withMoreSamples(chunk: string): string {
  return chunk.replace(SUM_OF_FIVE, SUM_OF_MORE);
}

/** Smooths the shadows of all renderers that are made from now on. Applied twice, it changes nothing more. */
export function smoothShadows(): void {
  ShaderChunk.shadowmap_pars_fragment = withMoreSamples(ShaderChunk.shadowmap_pars_fragment);
}

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
