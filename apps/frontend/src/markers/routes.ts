import type { RouteRecordRaw } from 'vue-router';

export const PRINT_MARKERS_PATH = '/devices/camera/print-markers';
export const PRINT_BOARD = `${PRINT_MARKERS_PATH}?what=board`;
export const CALIBRATE_PATH = '/devices/camera/calibrate';

const parent = { title: 'Camera', to: '/devices/camera' };

export const markersRoutes: readonly RouteRecordRaw[] = [
  {
    path: PRINT_MARKERS_PATH,
    component: () => import('./print/PrintMarkersPage.vue'),
    meta: { title: 'Print markers', parent },
  },
  {
    path: CALIBRATE_PATH,
    component: () => import('./calibration/CalibrateCameraPage.vue'),
    meta: { title: 'Calibrate', parent },
  },
];
