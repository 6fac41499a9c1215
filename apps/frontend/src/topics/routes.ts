import type { RouteRecordRaw } from 'vue-router';

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
