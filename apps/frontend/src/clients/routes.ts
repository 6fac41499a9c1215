import type { RouteLocationRaw, RouteRecordRaw } from 'vue-router';

/** The path of a client's own address. Some programs have ids that are no UUIDs. */
export const clientPath = (clientId: string): string =>
  `/clients/${encodeURIComponent(clientId).replaceAll('.', '%2E')}`;

/** Where a client is shown. The address can be shared. */
export const clientLocation = (clientId: string): RouteLocationRaw => ({
  path: clientPath(clientId),
});

export const clientsRoutes: readonly RouteRecordRaw[] = [
  {
    // Filters, order and view stand in the query; see filter/client-filter.ts.
    path: '/clients/:id?',
    component: () => import('./ClientsPage.vue'),
    meta: { title: 'Clients' },
  },
];
