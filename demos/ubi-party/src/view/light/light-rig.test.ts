import { ShaderChunk } from 'three';
import { expect, it } from 'vitest';

import { withMoreSamples } from './light-rig.ts';

it('knows how this version of three.js samples its soft shadows', () => {
  const chunk = withMoreSamples(ShaderChunk.shadowmap_pars_fragment);
  expect(chunk).toContain('vogelDiskSample( index, 14, phi )');
  expect(chunk).not.toContain('vogelDiskSample( 4, 5, phi )');
  expect(withMoreSamples(chunk)).toBe(chunk);
});
