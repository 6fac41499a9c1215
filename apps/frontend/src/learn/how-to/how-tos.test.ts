import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { createMemoryHistory, createRouter } from 'vue-router';
import { describe, expect, it } from 'vitest';
import { routes } from '../../routes.ts';
import { HOW_TOS } from './how-tos.ts';

const SOURCES = join(import.meta.dirname, '../..');
const ROOT = join(SOURCES, '../../..');
const read = (path: string): string => readFileSync(path, 'utf8');

/** Sources of all pages but these. */
const PAGES = readdirSync(SOURCES, { recursive: true, encoding: 'utf8' })
  .filter((path) => /\.(ts|vue)$/.test(path) && !/^learn\b|\.test\.ts$/.test(path))
  .map((path) => read(join(SOURCES, path)).replaceAll(/\s+/g, ' '));

const sentences = HOW_TOS.flatMap(({ id, intro, blocks }) => [
  { id, text: intro },
  ...blocks.flatMap((block) => {
    const texts = { steps: [], text: [], ...block };
    return [...texts.steps, texts.text].flat().map((text) => ({ id, text }));
  }),
]);
const namedTexts = sentences.flatMap(({ id, text }) =>
  [...text.matchAll(/\*\*([^*]+)\*\*/g)].map(([, name = '']) => ({ id, name })),
);

/** Whether the text stands alone in a template or as a literal, or before a part that varies. */
function isShown(name: string): boolean {
  const escaped = name.replaceAll(/[.*+?^${}()|[\]\\]/g, '\\$&');
  const shown = new RegExp(`[>'"\`}] ?${escaped} ?(?:[<'"\`]|\\{\\{|\\$\\{)`);
  return PAGES.some((source) => shown.test(source));
}

/** Where programs that are started with npm have their options. */
/** Options of all programs that join a master. */
const JOINING = 'packages/client-program/src/joining-options.ts';
const OPTIONS: Readonly<Record<string, readonly string[]>> = {
  start: ['apps/master/src/adapters/config/config.ts'],
  node: [JOINING, 'apps/node/src/options.ts'],
  record: [JOINING, 'apps/node/src/options.ts', 'apps/node/src/recordings/record.ts'],
  play: [JOINING, 'apps/node/src/options.ts', 'apps/node/src/recordings/play.ts'],
  info: ['apps/node/src/recordings/info.ts'],
  export: ['apps/node/src/recordings/export.ts'],
  import: ['apps/node/src/recordings/import.ts'],
};
const commands = HOW_TOS.flatMap(({ id, blocks }) =>
  blocks.flatMap((block) => {
    const code = block.kind === 'code' ? block.code : '';
    return [...code.matchAll(/npm (?:run )?(\w+) --(.*)/g)].map(([, script = '', rest = '']) => ({
      id,
      script,
      flags: [...rest.matchAll(/--([a-z-]+)/g)].map(([, flag = '']) => flag),
    }));
  }),
);

describe('how-to pages', () => {
  it('have addresses of their own', () => {
    expect(new Set(HOW_TOS.map(({ id }) => id)).size).toBe(HOW_TOS.length);
  });

  it('name texts of the interface as they are there', () => {
    expect(namedTexts.length).toBeGreaterThan(0);
    expect(namedTexts.filter(({ name }) => !isShown(name))).toEqual([]);
    expect(isShown('Keep the last hour of yesterday')).toBe(false);
  });

  it('link to pages that exist', () => {
    const router = createRouter({ history: createMemoryHistory(), routes: [...routes] });
    const links = HOW_TOS.flatMap(({ blocks }) =>
      blocks.flatMap((block) => (block.kind === 'link' ? [block.to] : [])),
    );
    const isUnknown = (to: string): boolean =>
      router.resolve(to).matched.every(({ path }) => path.includes('(.*)'));
    expect(links.filter(isUnknown)).toEqual([]);
    expect(isUnknown('/no/such/page')).toBe(true);
  });

  it.each(commands)('$id: npm run $script has $flags', ({ script, flags }) => {
    expect(JSON.parse(read(join(ROOT, 'package.json')))).toHaveProperty(`scripts.${script}`);
    const options = (OPTIONS[script] ?? []).flatMap((path) =>
      [...read(join(ROOT, path)).matchAll(/^ {2}(\w+): \w*[oO]ption\b/gm)].map(([, key = '']) =>
        key.replaceAll(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`),
      ),
    );
    expect(options).toEqual(expect.arrayContaining(flags));
  });
});
