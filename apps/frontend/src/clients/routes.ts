import type { RouteLocationRaw } from 'vue-router';

/** Where a client is shown. The address can be shared; some programs have ids that are no UUIDs. */
export function clientLocation(clientId: string): RouteLocationRaw {
  return { path: `/clients/${encodeURIComponent(clientId).replaceAll('.', '%2E')}` };
}
