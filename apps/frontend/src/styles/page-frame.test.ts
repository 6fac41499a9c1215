import { expect, it } from 'vitest';
import { expectNone, findInSource, type Find } from './find-in-source.ts';

const sources = import.meta.glob<string>('/src/**/*.{vue,css}', {
  query: '?raw',
  import: 'default',
  eager: true,
});
const STYLE_BLOCK = /<style[^>]*?(?:\ssrc="\.\/(?<src>[^"]+)")?[^>]*>(?<css>[\s\S]*?)<\/style>/g;
const EDGES = /(?<![-\w])(?:max-width|padding(?:-inline|-left|-right)?|margin-inline): [^;]+/g;

/** Classes of the outermost elements of a template. */
function rootClasses(source: string): readonly string[] {
  const template = /\n<template>\n([\s\S]*)\n<\/template>/.exec(source)?.[1] ?? '';
  return [...template.matchAll(/^ {2}<\w[^]*?>/gm)].flatMap(
    ([tag]) => /\sclass="([^"]*)"/.exec(tag)?.[1]?.split(/\s+/) ?? [],
  );
}

/** Edges that a page sets for itself, in its own styles. */
function ownEdges(path: string, source: string, read: (file: string) => string): readonly Find[] {
  const roots = rootClasses(source);
  return [...source.matchAll(STYLE_BLOCK)].flatMap(({ groups }) => {
    const file = groups?.['src'];
    const css = file === undefined ? (groups?.['css'] ?? '') : read(file);
    const rules = [...css.matchAll(/(?<selector>[^{}]+)\{(?<body>[^{}]*)\}/g)];
    return rules
      .filter(({ groups: rule }) => roots.some((name) => rule!['selector']!.trim() === `.${name}`))
      .flatMap(({ groups: rule }) => findInSource(path, rule!['body']!, EDGES));
  });
}

it('no page has edges or a width of its own', () => {
  const finds = Object.entries(sources)
    // Home for a new user has the same edges without the frame: it is the first load
    .filter(([path]) => /(?:Page|(?<!First)Home)\.vue$/.test(path))
    .flatMap(([path, source]) => {
      const folder = path.slice(0, path.lastIndexOf('/'));
      return ownEdges(path, source, (file) => sources[`${folder}/${file}`] ?? '');
    });
  expectNone(finds);
});

it('edges of a page would be found', () => {
  const source =
    '\n<template>\n  <div\n    class="mine grid"\n  />\n</template>\n<style scoped>\n.mine {\n  max-width: 720px;\n}\n</style>\n';
  expect(ownEdges('a.vue', source, () => '').map(({ text }) => text)).toEqual(['max-width: 720px']);
});
