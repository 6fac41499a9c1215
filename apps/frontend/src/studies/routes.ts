import type { RouteRecordRaw } from 'vue-router';

export const studiesRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/studies/:study?/:part(design|run|participants)?',
    component: () => import('./StudiesPage.vue'),
    meta: { title: 'Studies' },
  },
];
