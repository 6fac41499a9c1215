import type { RouteRecordRaw } from 'vue-router';
import { rememberStart } from '../install/start-path.ts';
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
    beforeEnter: () => rememberStart(path),
    meta: { title, parent: { title: 'Devices', to: '/devices' }, hasOwnHeader: true },
  })),
];
