import type { RouteRecordRaw } from 'vue-router';

export const callsRoutes: readonly RouteRecordRaw[] = [
  // What the page is called in the navigation; the master's own path answers clients
  { path: '/services', redirect: '/calls' },
  {
    path: '/calls/:service?',
    component: () => import('./CallsPage.vue'),
    meta: { title: 'Services' },
  },
];
