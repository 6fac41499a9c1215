import type { RouteRecordRaw } from 'vue-router';

/** How to make a device trust this master. Strangers and plain HTTP reach it, too. */
export const CERTIFICATE_PATH = '/connect/certificate';

export const certificateRoutes: readonly RouteRecordRaw[] = [
  {
    path: CERTIFICATE_PATH,
    component: () => import('./CertificatePage.vue'),
    meta: { title: 'Install the certificate', isBare: true },
  },
];
