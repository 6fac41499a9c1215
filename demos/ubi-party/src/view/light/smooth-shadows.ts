import { ShaderChunk } from 'three';

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
