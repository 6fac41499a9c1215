import type { RouteLocationRaw } from 'vue-router';

/** Path of a client's page. The ids of some programs are not UUIDs. */
export const clientPath = (clientId: string): string =>
  `/clients/${encodeURIComponent(clientId).replaceAll('.', '%2E')}`;

/** Location of a client's page; the URL can be shared. */
export const clientLocation = (clientId: string): RouteLocationRaw => ({
  path: clientPath(clientId),
});
