import type { RouteRecordRaw } from 'vue-router';
import { JOIN_PATH } from '../../locations/join-location.ts';

export const joinRoutes: readonly RouteRecordRaw[] = [
  {
    path: JOIN_PATH,
    component: () => import('./JoinPage.vue'),
    meta: { title: 'Join', isBare: true },
  },
];
