import type { FastifyInstance, FastifyRequest } from 'fastify';
import { ServiceError } from '@ubii/proto';
import type { Master } from '../../core/master/master.ts';
import type { CallerReader } from '../access/caller-reader.ts';
import { mayBeToken } from '../access/bearer.ts';
import type { OriginPolicy } from '../network/origin-policy.ts';
import { SDK_ROUTES } from './sdk-routes.ts';
import { SECURITY_HEADERS } from './security-headers.ts';
import { PATH_RIGHTS, type PathRight } from '../../core/access/rights-table.ts';

/** Time for which browsers may cache the reply to a preflight, seconds. */
const PREFLIGHT_MAX_AGE_S = 600;

interface OriginGuardContext {
  readonly policy: OriginPolicy;
  readonly master: Pick<Master, 'recognizes'>;
  readonly callers: Pick<CallerReader, 'read'>;
}

/** Whether a file of the client library is read, which pages need before they can show a token. [AC-5] */
function isLibrary({ method, routeOptions }: FastifyRequest): boolean {
  return (method === 'GET' || method === 'HEAD') && routeOptions.url === SDK_ROUTES.files;
}

/**
 * Looks at the origin of every request before anything else: refused ones end here, preflights are
 * answered here. [SV-8]
 */
export function guardOrigins(
  app: FastifyInstance,
  { policy, master, callers }: OriginGuardContext,
): void {
  /** Whether the page shows a token, or asks whether it may. [AC-46] */
  const hasToken = ({ method, headers, raw }: FastifyRequest): boolean => {
    if (method === 'OPTIONS') {
      return /(^|[ ,])authorization([ ,]|$)/i.test(
        String(headers['access-control-request-headers']),
      );
    }
    const caller = callers.read(raw);
    return mayBeToken(caller.bearer) && master.recognizes(caller);
  };

  app.addHook('onRequest', async (request, reply) => {
    reply.headers(SECURITY_HEADERS);
    const verdict = policy.judge(request.headers);
    const isNameless = verdict.kind === 'nameless';
    if (verdict.kind === 'refused' || (isNameless && !isLibrary(request) && !hasToken(request))) {
      throw new ServiceError('permission_denied', verdict.reason);
    }
    reply.header('vary', 'Origin');
    if (isNameless) reply.header('access-control-allow-origin', 'null');
    if (verdict.kind === 'allowed') {
      reply.header('access-control-allow-origin', verdict.origin);
    }
    if (request.method !== 'OPTIONS') return;
    reply.headers({
      allow: 'GET, HEAD, POST, OPTIONS',
      'access-control-allow-methods': 'GET, HEAD, POST, OPTIONS',
      'access-control-allow-headers':
        'Origin, X-Requested-With, Content-Type, Accept, Authorization', // [AC-13]
      'access-control-max-age': String(PREFLIGHT_MAX_AGE_S),
    });
    // Browsers ask before a page of a public address reaches into a private network.
    if (request.headers['access-control-request-private-network'] === 'true') {
      reply.header('access-control-allow-private-network', 'true');
    }
    return reply.code(204).send();
  });
}

interface PathRightsContext {
  readonly master: Pick<Master, 'roleOf'>;
  readonly callers: Pick<CallerReader, 'read'>;
}

/**
 * Serves no path that the table of rights does not have, and each to the roles that its row names. To be
 * called before the routes are added. [AC-5]
 *
 * @throws Error from the start of the application when a route has no row
 */
export function guardPaths(app: FastifyInstance, { master, callers }: PathRightsContext): void {
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
