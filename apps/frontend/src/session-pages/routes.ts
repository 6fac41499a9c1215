import type { RouteRecordRaw } from 'vue-router';

export const sessionsRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/sessions',
    component: () => import('./SessionsPage.vue'),
    meta: { title: 'Sessions' },
  },
];
