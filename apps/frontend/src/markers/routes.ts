import type { RouteRecordRaw } from 'vue-router';

export const PRINT_MARKERS_PATH = '/devices/camera/print-markers';

const parent = { title: 'Camera', to: '/devices/camera' };

export const markersRoutes: readonly RouteRecordRaw[] = [
  {
    path: PRINT_MARKERS_PATH,
    component: () => import('./print/PrintMarkersPage.vue'),
    meta: { title: 'Print markers', parent },
  },
];
