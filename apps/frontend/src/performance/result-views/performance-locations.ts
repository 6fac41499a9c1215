import type { RouteLocationRaw } from 'vue-router';

/** Where one kept run is shown. */
export function resultLocation(id: string): RouteLocationRaw {
  return { path: `/performance/results/${encodeURIComponent(id)}` };
}

/** Where runs are compared; the first is what the others are compared with. */
export function compareLocation(ids: readonly string[]): RouteLocationRaw {
  return { path: '/performance/compare', query: { runs: ids.join(',') } };
}
