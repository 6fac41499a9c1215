import type { RouteRecordRaw } from 'vue-router';

export const topicsRoutes: readonly RouteRecordRaw[] = [
  {
    // The topic itself stands in the query: topics may hold any character. `/topics?topic=/a/b`
    path: '/topics',
    component: () => import('./TopicsPage.vue'),
    meta: { title: 'Topics' },
  },
];
