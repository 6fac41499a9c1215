import type { RouteRecordRaw } from 'vue-router';

export const callsRoutes: readonly RouteRecordRaw[] = [
  // Alias after the name in the navigation; `/services` on the master itself is for clients.
  { path: '/services', redirect: '/calls' },
  {
    path: '/calls/:service?',
    component: () => import('./CallsPage.vue'),
    meta: { title: 'Services' },
  },
];
