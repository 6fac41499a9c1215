import type { RouteRecordRaw } from 'vue-router';
import { DEVICE_PAGES } from './catalogue.ts';

export const devicesRoutes: readonly RouteRecordRaw[] = [
  {
    path: '/devices',
    component: () => import('./DevicesPage.vue'),
    meta: { title: 'Devices' },
  },
  ...DEVICE_PAGES.map(({ path, title, page }) => ({
    path,
    component: page,
    meta: { title, parent: { title: 'Devices', to: '/devices' }, hasOwnHeader: true },
  })),
];
