import { describe, expect, it } from 'vitest';
import { nodeMeasures } from '../graph/nodes/node-geometry.ts';
import { blank, expectNone, findInSource, type Find } from './find-in-source.ts';

const sources = import.meta.glob<string>('/src/**/*.{vue,css,ts}', {
  query: '?raw',
  import: 'default',
  eager: true,
});
const tokens = sources['/src/styles/tokens.css']!;

/** Matches colour literals in a style sheet. Mixed tokens are allowed. */
const STYLE_COLOUR =
  /#[0-9a-f]{3,8}\b|\b(?:rgba?|hsla?|hwb|oklch|oklab|lch|lab)\(|:[^;{}]*(?<![\w-])(?:white|black|red|green|blue|gr[ae]y|orange|yellow|purple|pink)(?![\w-])/gi;
/** Matches colour literals in code: a whole string. `#name` outside a string is a private member. */
const SCRIPT_COLOUR =
  /(['"`])#(?:[0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})\1|['"`](?:rgba?|hsla?|oklch)\(/gi;

const STYLE_BLOCK = /(<style[^>]*>[\s\S]*?<\/style>)/g;

function colourLiterals(path: string, source: string): Find[] {
  const code = source.replace(/\/\*[\s\S]*?\*\//g, blank);
  if (path.endsWith('.css')) return findInSource(path, code, STYLE_COLOUR);
  const styles = code.split(STYLE_BLOCK).map((part, i) => (i % 2 === 1 ? part : blank(part)));
  return [
    ...findInSource(path, code.replace(STYLE_BLOCK, blank), SCRIPT_COLOUR),
    ...findInSource(path, styles.join(''), STYLE_COLOUR),
  ];
}

/** Sources without tests, in which wrong values stand on purpose. */
const product = Object.entries(sources).filter(([path]) => !path.endsWith('.test.ts'));

describe('colour literals', () => {
  it('stand in tokens.css only', () => {
    const others = product.filter(([path]) => path !== '/src/styles/tokens.css');
    expectNone(others.flatMap(([path, source]) => colourLiterals(path, source)));
  });

  it('would be found', () => {
    const reports = (path: string, source: string): string[] =>
      colourLiterals(path, source).map(({ report }) => report);
    expect(reports('a.css', 'a {\n  color: #fff;\n  border: 1px solid red;\n}')).toEqual([
      'a.css:2: #fff',
      'a.css:3: : 1px solid red',
    ]);
    expect(reports('a.ts', "/*\n*/ line.color = '#c0f03f'; this.#add(1);")).toEqual([
      "a.ts:2: '#c0f03f'",
    ]);
    expect(reports('a.vue', '<p />\n<style scoped>\na { fill: rgb(0 0 0); }</style>')).toEqual([
      'a.vue:3: rgb(',
    ]);
  });
});

it('every token that is used is defined', () => {
  const all = Object.values(sources).join('\n');
  const definition = /(--[\w-]+)['"]?\s*:|setProperty\('(--[\w-]+)'/g;
  const defined = new Set([...all.matchAll(definition)].map((match) => match[1] ?? match[2]));
  for (const [name] of nodeMeasures()) defined.add(name);
  const used = Object.entries(sources).flatMap(([path, source]) =>
    findInSource(path, source, /var\((?<name>--[\w-]+)[,)]/g),
  );
  // Set by the component library.
  expectNone(used.filter(({ text }) => !defined.has(text) && !text.startsWith('--reka-')));
});

it('nothing is loaded from elsewhere', () => {
  const load = /(?:url\(|src=|href=|import\s*\(?\s*)['"]?(?:https?:)?\/\//g;
  expectNone(product.flatMap(([path, source]) => findInSource(path, source, load)));
});

/** Values of a theme: `light-dark(light, dark)`, or one value for both. */
function theme(index: 0 | 1): Map<string, string> {
  const values = new Map<string, string>();
  for (const [, name, light, dark] of tokens.matchAll(
    /--([\w-]+): light-dark\((#[0-9a-f]+), (#[0-9a-f]+)\);/g,
  )) {
    if (!values.has(name!)) values.set(name!, index === 0 ? light! : dark!);
  }
  return values;
}

function luminance(hex: string): number {
  const [r, g, b] = [1, 3, 5].map((start) => {
    const share = parseInt(hex.slice(start, start + 2), 16) / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
}

/** WCAG 2.2 contrast ratio. */
function contrast(one: string, other: string): number {
  const [low, high] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (high! + 0.05) / (low! + 0.05);
}

const SURFACES = ['bg', 'canvas', 's1', 's2', 's3'];
const TEXT = ['ink-1', 'ink-2', 'ink-3', 'live', 'warn', 'err'];
const FAMILIES = ['number', 'vector', 'rotation', 'event', 'text', 'image', 'objects', 'pose'];

describe.each([
  ['light', 0],
  ['dark', 1],
] as const)('contrast of the %s theme', (_name, index) => {
  const values = theme(index);
  const of = (name: string): string => {
    const value = values.get(name);
    if (value === undefined) throw new Error(`--${name} is not a light-dark() token.`);
    return value;
  };

  it.each([...TEXT, ...FAMILIES.map((family) => `family-${family}`)])(
    '%s is readable on every surface',
    (ink) => {
      for (const surface of SURFACES) {
        expect(contrast(of(ink), of(surface)), `${ink} on ${surface}`).toBeGreaterThanOrEqual(4.5);
      }
    },
  );

  it.each(['live', 'warn', 'err', ...FAMILIES.map((family) => `family-${family}`)])(
    '%s is readable on its own tint',
    (ink) => {
      expect(contrast(of(ink), of(`${ink}-tint`))).toBeGreaterThanOrEqual(4.5);
    },
  );

  it('edges of controls can be seen', () => {
    for (const surface of SURFACES) {
      expect(contrast(of('control'), of(surface)), surface).toBeGreaterThanOrEqual(3);
    }
  });

  it('text on a primary button is readable', () => {
    expect(contrast(of('inv'), of('ink-1'))).toBeGreaterThanOrEqual(4.5);
    expect(contrast(of('inv'), of('err'))).toBeGreaterThanOrEqual(4.5);
  });
});
