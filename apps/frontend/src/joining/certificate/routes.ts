import type { RouteRecordRaw } from 'vue-router';
import { CERTIFICATE_PATH } from '../../locations/certificate-location.ts';

export const certificateRoutes: readonly RouteRecordRaw[] = [
  {
    path: CERTIFICATE_PATH,
    component: () => import('./CertificatePage.vue'),
    meta: { title: 'Install the certificate', isBare: true },
  },
];
