import type { RouteRecordRaw } from 'vue-router';

/** Where strangers come to. The token of a QR code stands in the fragment. [AC-5] [AC-11] */
export const JOIN_PATH = '/join';

export const joinRoutes: readonly RouteRecordRaw[] = [
  {
    path: JOIN_PATH,
    component: () => import('./JoinPage.vue'),
    meta: { title: 'Join', isBare: true },
  },
];
