import type { RouteRecordRaw } from 'vue-router';
import { CALIBRATE_PATH, PRINT_MARKERS_PATH } from '../locations/marker-locations.ts';

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
