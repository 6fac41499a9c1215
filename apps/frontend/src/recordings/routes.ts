import type { RouteRecordRaw } from 'vue-router';

export const recordingsRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/recordings/:recording?',
    component: () => import('./RecordingsPage.vue'),
    meta: { title: 'Recordings', isFullBleed: true, ownKeys: 'M' },
  },
];
