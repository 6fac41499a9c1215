import type { RouteLocationRaw } from 'vue-router';

/**
 * Where a topic is shown. The address can be shared; topics may hold any character. Dots are written
 * as `%2E`, or a topic that ends like a filename would be looked for among the files of the master.
 */
export function topicLocation(topic: string): RouteLocationRaw {
  return { path: `/topics/${encodeURIComponent(topic).replaceAll('.', '%2E')}` };
}

/** Where several topics are looked at at once; with a topic, a panel of it is added. */
export function panelsLocation(topic?: string): RouteLocationRaw {
  return { path: '/panels', query: topic === undefined ? {} : { topic } };
}
