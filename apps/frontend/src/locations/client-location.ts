import type { RouteLocationRaw } from 'vue-router';

/** The path of a client's own address. Some programs have ids that are no UUIDs. */
export const clientPath = (clientId: string): string =>
  `/clients/${encodeURIComponent(clientId).replaceAll('.', '%2E')}`;

/** Where a client is shown. The address can be shared. */
export const clientLocation = (clientId: string): RouteLocationRaw => ({
  path: clientPath(clientId),
});
