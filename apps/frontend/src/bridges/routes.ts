import type { RouteRecordRaw } from 'vue-router';

export const bridgesRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/bridges/:id?',
    component: () => import('./BridgesPage.vue'),
    meta: { title: 'Bridges' },
  },
];
