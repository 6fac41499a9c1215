import { expect, test } from 'vitest';
import { pageColoursOf, styleOf } from './page-colours.ts';

/** Relative luminance and contrast, WCAG 2.2. */
function luminance(colour: string): number {
  const [r, g, b] = [1, 3, 5].map((at) => {
    const share = parseInt(colour.slice(at, at + 2), 16) / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
}

function contrast(a: string, b: string): number {
  const [dark, light] = [luminance(a), luminance(b)].sort((one, other) => one - other);
  return (light! + 0.05) / (dark! + 0.05);
}

const PAGES = [undefined, ...Array.from({ length: 32 }, (_, seat) => seat)];

test.each(PAGES)('seat %s: sentences and buttons can be read', (seat) => {
  const colours = pageColoursOf(seat);
  expect(contrast(colours.text, colours.page)).toBeGreaterThan(4.5);
  expect(contrast(colours.onButton, colours.button)).toBeGreaterThan(4.5);
  expect(contrast(colours.onToken, colours.token)).toBeGreaterThan(4.5);
});

test.each(PAGES)('seat %s: what fills up differs from what it lies on', (seat) => {
  const colours = pageColoursOf(seat);
  expect(contrast(colours.accent, colours.plate)).toBeGreaterThan(3);
  expect(contrast('#fff6e4', colours.plate)).toBeGreaterThan(3);
});

test('colours become custom properties', () => {
  expect(styleOf(pageColoursOf(0))).toMatchObject({ '--page': '#f2543d', '--on-token': '#221c14' });
});
