import type { RouteRecordRaw } from 'vue-router';
import { CONNECT_PROGRAM_PATH } from '../../locations/connect-location.ts';

export const connectProgramRoutes: readonly RouteRecordRaw[] = [
  {
    path: CONNECT_PROGRAM_PATH,
    component: () => import('./ConnectProgramPage.vue'),
    meta: { title: 'Connect a program', parent: { title: 'Clients', to: '/clients' } },
  },
];
