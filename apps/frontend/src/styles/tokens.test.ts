import { describe, expect, it } from 'vitest';
import { nodeMeasures } from '../graph/nodes/node-geometry.ts';

const sources = import.meta.glob<string>('../**/*.{vue,css,ts}', {
  query: '?raw',
  import: 'default',
  eager: true,
});
const tokens = sources['./tokens.css']!;

/** Matches colour literals in a style sheet. Mixed tokens are allowed. */
const STYLE_COLOUR =
  /#[0-9a-f]{3,8}\b|\b(?:rgba?|hsla?|hwb|oklch|oklab|lch|lab)\(|:[^;{}]*(?<![\w-])(?:white|black|red|green|blue|gr[ae]y|orange|yellow|purple|pink)(?![\w-])/gi;
/** Matches colour literals in code: a whole string. `#name` outside a string is a private member. */
const SCRIPT_COLOUR =
  /(['"`])#(?:[0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})\1|['"`](?:rgba?|hsla?|oklch)\(/gi;

const STYLE_BLOCK = /<style[^>]*>([\s\S]*?)<\/style>/g;

function literals(path: string, source: string): string[] {
  const code = source.replace(/\/\*[\s\S]*?\*\//g, '');
  const isStyle = path.endsWith('.css');
  const blocks = [...code.matchAll(STYLE_BLOCK)].map((match) => match[1]).join('\n');
  const styles = isStyle ? code : blocks;
  const script = isStyle ? '' : code.replace(STYLE_BLOCK, '');
  return [...(styles.match(STYLE_COLOUR) ?? []), ...(script.match(SCRIPT_COLOUR) ?? [])];
}

describe('colour literals', () => {
  const others = Object.entries(sources).filter(
    ([path]) => path !== './tokens.css' && !path.endsWith('.test.ts'),
  );

  it.each(others)('%s has none: colours are tokens', (path, source) => {
    expect(literals(path, source)).toEqual([]);
  });

  it('would be found', () => {
    expect(literals('a.css', 'a { color: #fff; border: 1px solid red; }')).toHaveLength(2);
    expect(literals('a.ts', "line.color = '#c0f03f'; this.#add(1);")).toHaveLength(1);
    expect(literals('a.vue', '<style scoped>a { fill: rgb(0 0 0); }</style>')).toHaveLength(1);
  });
});

it('every token that is used is defined', () => {
  const all = Object.values(sources).join('\n');
  const definition = /(--[\w-]+)['"]?\s*:|setProperty\('(--[\w-]+)'/g;
  const defined = new Set([...all.matchAll(definition)].map((match) => match[1] ?? match[2]));
  for (const [name] of nodeMeasures()) defined.add(name);
  const used = new Set([...all.matchAll(/var\((--[\w-]+)[,)]/g)].map((match) => match[1]!));
  // Set by the component library.
  const missing = [...used].filter((name) => !defined.has(name) && !name.startsWith('--reka-'));
  expect(missing).toEqual([]);
});

it('nothing is loaded from elsewhere', () => {
  const loads = Object.entries(sources)
    .filter(([path]) => !path.endsWith('.test.ts'))
    .filter(([, source]) =>
      /(?:url\(|src=|href=|import\s*\(?\s*)['"]?(?:https?:)?\/\//.test(source),
    );
  expect(loads.map(([path]) => path)).toEqual([]);
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
