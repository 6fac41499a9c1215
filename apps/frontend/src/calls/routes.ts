import type { ServiceName } from '@ubii/proto';
import type { RouteRecordRaw } from 'vue-router';

export const callLocation = (service: ServiceName): string => `/calls/${service}`;

export const callsRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/calls/:service?',
    component: () => import('./CallsPage.vue'),
    meta: { title: 'Services' },
  },
];
