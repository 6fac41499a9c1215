import type { RouteLocationRaw } from 'vue-router';

/** Location of a bridge. */
export function bridgeLocation(id: string): RouteLocationRaw {
  return { path: `/bridges/${encodeURIComponent(id)}` };
}
