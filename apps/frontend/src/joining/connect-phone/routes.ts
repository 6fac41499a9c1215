import type { RouteRecordRaw } from 'vue-router';
import { CONNECT_PATH } from '../../locations/connect-location.ts';

export const connectPhoneRoutes: readonly RouteRecordRaw[] = [
  {
    path: CONNECT_PATH,
    component: () => import('./ConnectPhonePage.vue'),
    meta: { title: 'Connect a phone', ownKeys: 'CF' },
  },
];
