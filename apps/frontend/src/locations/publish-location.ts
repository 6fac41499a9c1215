import type { RouteLocationRaw } from 'vue-router';

/** Location of the Publish page, with an initial topic. */
export function publishLocation(topic?: string): RouteLocationRaw {
  return topic === undefined ? '/publish' : { path: '/publish', query: { topic } };
}
