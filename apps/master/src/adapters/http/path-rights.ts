import type { FastifyInstance, FastifyRequest } from 'fastify';
import { ServiceError } from '@ubii/proto';

import { PATH_RIGHTS } from '../../core/access/rights-table.ts';
import type { PathRight } from '../../core/access/rights-table.ts';
import type { Master } from '../../core/master/master.ts';
import type { CallerReader } from '../access/caller-reader.ts';

export interface PathRightsOptions {
  readonly master: Pick<Master, 'roleOf'>;
  readonly callers: Pick<CallerReader, 'read'>;
}

/**
 * Serves no path that the table of rights does not have, and each to the roles that its row names. To be
 * called before the routes are added. [AC-5]
 *
 * @throws Error from the start of the application when a route has no row
 */
export function guardPaths(app: FastifyInstance, { master, callers }: PathRightsOptions): void {
  app.addHook('onRoute', ({ method, url }) => {
    for (const each of [method].flat()) {
      if (rowOf(each, url) === undefined) {
        throw new Error(`The route ${each} ${url} has no row in the table of rights.`);
      }
    }
  });
  app.addHook('onRequest', async ({ method, routeOptions, raw }: FastifyRequest) => {
    const row = rowOf(method, routeOptions.url ?? '');
    // Most rows allow all callers, so that the role is not needed.
    if (row === undefined || row.roles.includes('none')) return;
    const role = master.roleOf(callers.read(raw));
    if (row.roles.includes(role)) return;
    const roles = row.roles.map((each) => `${each}s`).join(', ');
    throw role === 'none'
      ? new ServiceError('unauthenticated', `${row.path} is for ${roles}. Send a credential.`)
      : new ServiceError(
          'permission_denied',
          `${row.path} is for ${roles}; the caller is a ${role}.`,
        );
  });
}

/** The row for a route. A HEAD request is a GET request without the content. */
function rowOf(method: string, url: string): PathRight | undefined {
  const asked = method === 'HEAD' ? 'GET' : method;
  return PATH_RIGHTS.find((row) => row.method === asked && row.path === url);
}
