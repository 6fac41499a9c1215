import type { RouteRecordRaw } from 'vue-router';

export const CONNECT_PATH = '/connect';

export const connectPhoneRoutes: readonly RouteRecordRaw[] = [
  {
    path: CONNECT_PATH,
    component: () => import('./ConnectPhonePage.vue'),
    meta: { title: 'Connect a phone' },
  },
];
