import type { FastifyInstance } from 'fastify';
import { ServiceError } from '@ubii/proto';

import type { OriginPolicy } from '../network/origin-policy.ts';
import { SECURITY_HEADERS } from './security-headers.ts';

/** How long a browser may keep the answer to a preflight, seconds. */
const PREFLIGHT_MAX_AGE_S = 600;

/**
 * Looks at the origin of every request before anything else: refused ones end here, preflights are
 * answered here. [SV-8]
 */
export function guardOrigins(app: FastifyInstance, policy: OriginPolicy): void {
  app.addHook('onRequest', async (request, reply) => {
    reply.headers(SECURITY_HEADERS);
    const verdict = policy.judge(request.headers);
    if (verdict.kind === 'refused') {
      throw new ServiceError('permission_denied', verdict.reason);
    }
    reply.header('vary', 'Origin');
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
