import { expect, it } from 'vitest';

const sources = import.meta.glob<string>('../**/*.{vue,css}', {
  query: '?raw',
  import: 'default',
  eager: true,
});

const STYLE_BLOCK = /<style[^>]*>([\s\S]*?)<\/style>/g;

function classes(text: string, pattern: RegExp): string[] {
  return [...text.matchAll(pattern)].flatMap((match) => match[1]!.split(/\s+/)).filter(Boolean);
}

const stylesOf = (path: string, source: string): string =>
  path.endsWith('.css')
    ? source
    : [...source.matchAll(STYLE_BLOCK)].map((match) => match[1]).join('\n');
/** In a style sheet the colon of `hover:ink-1` is escaped. */
const rulesOf = (styles: string): string[] =>
  classes(styles, /\.([a-z](?:\\:|[\w-])*)/gi).map((name) => name.replace('\\', ''));

const templates = Object.entries(sources)
  .filter(([path]) => path.endsWith('.vue'))
  .map(([path, source]) => ({ path, source: source.replace(STYLE_BLOCK, '') }));
const ruled = new Set(
  Object.entries(sources).flatMap(([path, source]) => rulesOf(stylesOf(path, source))),
);

/** Returns classes of a component that have no rule and are not used by code. */
function unknownClasses(source: string): string[] {
  return classes(source, /\sclass="([^"]*)"/g).filter(
    (name) => !ruled.has(name) && !new RegExp(`['"\`][^'"\`\\n]*\\.${name}\\b`).test(source),
  );
}

it.each(templates)('$path has no class without a rule', ({ source }) => {
  expect(unknownClasses(source)).toEqual([]);
});

it('a class without a rule would be found', () => {
  expect(unknownClasses('<p class="hstack gap-99" />')).toEqual(['gap-99']);
});

it('every utility is used', () => {
  const used = new Set(
    templates.flatMap(({ source }) => [
      ...classes(source, /\sclass="([^"]*)"/g),
      ...classes(source, /'([\w: -]+)'/g),
      ...classes(source, /[{,]\s*([\w-]+)\s*[:,}]/g),
    ]),
  );
  const utilities = Object.entries(sources)
    .filter(([path]) => path.startsWith('./utilities/'))
    .flatMap(([, source]) => rulesOf(source.replace(/\/\*[\s\S]*?\*\//g, '')));
  expect(utilities.length).toBeGreaterThan(100);
  expect(utilities.filter((name) => !used.has(name))).toEqual([]);
});
