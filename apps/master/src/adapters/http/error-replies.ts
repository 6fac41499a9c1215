import type { FastifyInstance } from 'fastify';
import { ServiceError, toJson } from '@ubii/proto';
import type { ServiceErrorCode } from '@ubii/proto';

import type { Log } from '../../core/ports/index.ts';

/** The status of a response that is no service reply; the column HTTP of docs/errors.md. */
const STATUS_OF: { readonly [C in ServiceErrorCode]: number } = {
  invalid_argument: 400,
  failed_precondition: 400,
  unauthenticated: 401,
  permission_denied: 403,
  not_found: 404,
  already_exists: 409,
  resource_exhausted: 429,
  internal: 500,
  unimplemented: 501,
  unavailable: 503,
  deadline_exceeded: 504,
};

/** Turns whatever a route throws into a status and a body that looks like the error of a service reply. */
export function replyErrors(app: FastifyInstance, log: Log): void {
  app.setErrorHandler((thrown: Error, request, reply) => {
    const refused = isRefusal(thrown);
    const error = refused
      ? new ServiceError('invalid_argument', thrown.message)
      : ServiceError.from(thrown);
    if (error.code === 'internal') {
      log.error('a request failed', {
        method: request.method,
        route: request.routeOptions.url,
        reason: thrown.message,
        stack: thrown.stack,
      });
    }
    return reply
      .code(refused ? thrown.statusCode : STATUS_OF[error.code])
      .header('cache-control', 'no-store')
      .type('application/json; charset=utf-8')
      .send(JSON.stringify(toJson('ubii.services.ServiceReply', { error: error.toWire() })));
  });
}

/** The framework's own refusals, of a header it cannot read, say, carry a status and a sentence. */
export function isRefusal(thrown: unknown): thrown is Error & { readonly statusCode: number } {
  return (
    thrown instanceof Error &&
    'statusCode' in thrown &&
    typeof thrown.statusCode === 'number' &&
    thrown.statusCode < 500
  );
}
