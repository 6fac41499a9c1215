import type { RouteLocationRaw } from 'vue-router';

/** Location of a stored run. */
export function resultLocation(id: string): RouteLocationRaw {
  return { path: `/performance/results/${encodeURIComponent(id)}` };
}

/** Location of a comparison; the first run is the reference. */
export function compareLocation(ids: readonly string[]): RouteLocationRaw {
  return { path: '/performance/compare', query: { runs: ids.join(',') } };
}
