import { expect, it } from 'vitest';
import { blank, expectNone, findInSource, type Find } from './find-in-source.ts';

const sources = import.meta.glob<string>('/src/**/*.{vue,css}', {
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
const RULE = /\.(?<name>[a-z](?:\\:|[\w-])*)/gi;
const withoutEscape = (name: string): string => name.replace('\\', '');

const templates = Object.entries(sources)
  .filter(([path]) => path.endsWith('.vue'))
  .map(([path, source]) => ({ path, source: source.replace(STYLE_BLOCK, blank) }));
const ruled = new Set(
  Object.entries(sources).flatMap(([path, source]) =>
    classes(stylesOf(path, source), RULE).map(withoutEscape),
  ),
);

/** Returns classes of a component that have no rule and are not used by code. */
function unknownClasses(path: string, source: string): Find[] {
  const names = [...source.matchAll(/(\sclass=")([^"]*)"/g)].flatMap(
    ({ index, 1: name = '', 2: value }) =>
      findInSource(path, blank(source.slice(0, index + name.length)) + value, /\S+/g),
  );
  return names.filter(
    ({ text }) => !ruled.has(text) && !new RegExp(`['"\`][^'"\`\\n]*\\.${text}\\b`).test(source),
  );
}

it('no component has a class without a rule', () => {
  expectNone(templates.flatMap(({ path, source }) => unknownClasses(path, source)));
});

it('a class without a rule would be found', () => {
  const source = '<p\n  class="hstack\n    gap-99"\n/>';
  expect(unknownClasses('a.vue', source).map(({ report }) => report)).toEqual(['a.vue:3: gap-99']);
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
    .filter(([path]) => path.startsWith('/src/styles/utilities/'))
    .flatMap(([path, source]) =>
      findInSource(path, source.replace(/\/\*[\s\S]*?\*\//g, blank), RULE),
    );
  expect(utilities.length).toBeGreaterThan(100);
  expectNone(utilities.filter(({ text }) => !used.has(withoutEscape(text))));
});
