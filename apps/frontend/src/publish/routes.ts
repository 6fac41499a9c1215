import type { RouteRecordRaw } from 'vue-router';

export const publishRoutes: readonly RouteRecordRaw[] = [
  {
    // `?topic=/a/b` starts with the newest value of that topic.
    path: '/publish',
    component: () => import('./PublishPage.vue'),
    meta: { title: 'Publish' },
  },
];
