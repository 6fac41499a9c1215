import type { RouteLocationRaw, RouteRecordRaw } from 'vue-router';

/**
 * Where a topic is shown. The address can be shared; topics may hold any character. Dots are written
 * as `%2E`, or a topic that ends like a file name would be looked for among the files of the master.
 */
export function topicLocation(topic: string): RouteLocationRaw {
  return { path: `/topics/${encodeURIComponent(topic).replaceAll('.', '%2E')}` };
}

/** Where several topics are looked at at once; with a topic, a panel of it is added. */
export function panelsLocation(topic?: string): RouteLocationRaw {
  return { path: '/panels', query: topic === undefined ? {} : { topic } };
}

export const topicsRoutes: readonly RouteRecordRaw[] = [
  {
    // Also `/topics?topic=/a/b` and `/topics?client=<client id>`, for links that are made by hand.
    path: '/topics/:topic?',
    component: () => import('./TopicsPage.vue'),
    meta: { title: 'Topics' },
  },
  {
    // A layout of panels stands behind `#layout=`, which browsers keep to themselves.
    path: '/panels',
    component: () => import('./panels/PanelsPage.vue'),
    meta: { title: 'Panels', parent: { title: 'Topics', to: '/topics' } },
  },
];
