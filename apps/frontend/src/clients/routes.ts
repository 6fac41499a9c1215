import type { RouteRecordRaw } from 'vue-router';

export const clientsRoutes: readonly RouteRecordRaw[] = [
  {
    // Filters, order and view are in the query; see filter/client-filter.ts.
    path: '/clients/:id?',
    component: () => import('./ClientsPage.vue'),
    meta: { title: 'Clients' },
  },
];
