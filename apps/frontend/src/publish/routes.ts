import type { RouteLocationRaw, RouteRecordRaw } from 'vue-router';

/** Location of the Publish page, with a topic to start with. */
export function publishLocation(topic?: string): RouteLocationRaw {
  return topic === undefined ? '/publish' : { path: '/publish', query: { topic } };
}

export const publishRoutes: readonly RouteRecordRaw[] = [
  {
    // `?topic=/a/b` starts with the newest value of that topic.
    path: '/publish',
    component: () => import('./PublishPage.vue'),
    meta: { title: 'Publish' },
  },
];
