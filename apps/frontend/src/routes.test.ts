import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { createMemoryHistory, createRouter } from 'vue-router';

import { routes } from './routes.ts';

const LIST = resolve(import.meta.dirname, '../../../e2e/tests/accessibility/pages.json');

interface Pages {
  /** Addresses that are opened as they are. */
  readonly opened: readonly string[];
  /** Addresses of pages for which something is made first. */
  readonly inStories: readonly string[];
}

describe('pages whose accessibility is checked in browsers', () => {
  const { opened, inStories } = JSON.parse(readFileSync(LIST, 'utf8')) as Pages;
  const router = createRouter({ history: createMemoryHistory(), routes });
  const shownBy = (path: string) => router.resolve(path).matched.at(-1)?.path;

  it('are all there are', () => {
    const checked = new Set([...opened, ...inStories].map(shownBy));
    const parents = new Set(
      router.getRoutes().flatMap(({ path, children }) => (children.length > 0 ? [path] : [])),
    );
    const missing = router
      .getRoutes()
      .filter(({ path, redirect }) => !parents.has(path) && redirect === undefined)
      .map(({ path }) => path)
      .filter((path) => !checked.has(path));
    expect(missing).toEqual([]);
  });

  it('are each opened once', () => {
    expect(opened).toEqual([...new Set(opened)]);
  });
});
