import type { RouteRecordRaw } from 'vue-router';

export const topicsRoutes: readonly RouteRecordRaw[] = [
  {
    // Also `/topics?topic=/a/b` and `/topics?client=<client id>`, for links written by hand.
    path: '/topics/:topic?',
    component: () => import('./TopicsPage.vue'),
    meta: { title: 'Topics' },
  },
  {
    // The layout of the panels is in `#layout=`, which browsers do not send to servers.
    path: '/panels',
    component: () => import('./panels/PanelsPage.vue'),
    meta: { title: 'Panels', parent: { title: 'Topics', to: '/topics' } },
  },
];
