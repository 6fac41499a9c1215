// @vitest-environment happy-dom
import { expect, it } from 'vitest';
import { plotTheme } from './plot-theme.ts';

it('names sizes of fonts in whole pixels, which uPlot scales by the device pixel ratio', () => {
  const { font, labelFont } = plotTheme(document.createElement('i'));
  for (const face of [font, labelFont]) expect(face).toMatch(/(^| )\d+px /);
});
