import { PassThrough } from 'node:stream';
import type { IncomingMessage } from 'node:http';
import type { FastifyInstance, FastifyReply, FastifyRequest } from 'fastify';
import { ServiceError } from '@ubii/proto';

import type { ServiceAnswer } from '../../core/master/master.ts';
import type { CallerReader } from '../access/caller-reader.ts';
import type { ConnectionGuard } from '../network/connection-guard.ts';
import { answerRequest, type AnswerContext } from '../services/answer-request.ts';
import { drain } from '../services/bodies/drain.ts';
import { binaryFormat, formatOf, jsonFormat } from '../services/service-format.ts';
import type { ServiceFormat } from '../services/service-format.ts';
import { isRefusal } from './error-replies.ts';

export interface ServicesContext extends AnswerContext {
  readonly callers: Pick<CallerReader, 'read'>;
  /** Is told whose connections are. */
  readonly connectionGuard: Pick<ConnectionGuard, 'of'>;
}

/** Services over HTTP: always status 200 with a reply, errors included. [SV-1] */
export function addServices(app: FastifyInstance, context: ServicesContext): void {
  // Whatever a client calls its content, the path says what it is. Bodies are read by the handler,
  // which knows the caller first.
  app.removeAllContentTypeParsers();
  app.addContentTypeParser('*', (_request, _payload, done) => done(null));

  const addRoute = (path: string, formatFor: (request: FastifyRequest) => ServiceFormat): void => {
    app.post(path, {
      handler: async (request, reply) => {
        const format = formatFor(request);
        return send(request, reply, format, await answerTo(request, format, context), context);
      },
      // The framework refuses some requests on its own, for a header it cannot read. [SV-1]
      errorHandler: (error, request, reply) => {
        if (ServiceError.from(error).code === 'permission_denied') throw error;
        const refusal = isRefusal(error)
          ? new ServiceError('invalid_argument', error.message)
          : error;
        const answer = context.master.refuseServiceRequest(refusal);
        void send(request, reply.code(200), formatFor(request), answer, context);
      },
    });
  };
  addRoute('/services/json', () => jsonFormat);
  addRoute('/services/binary', () => binaryFormat);
  addRoute('/services', ({ headers }) => formatOf(headers['content-type']));
}

function send(
  { raw }: FastifyRequest,
  reply: FastifyReply,
  format: ServiceFormat,
  answer: ServiceAnswer,
  { clock }: ServicesContext,
): FastifyReply {
  // Actions that wait for the reply run after it was sent, or after its receiver disconnected. [TD-24]
  reply.raw.once('close', () => answer.afterReply());
  const encoded = format.encodeReply(answer.reply);
  reply.header('content-type', format.contentType).header('cache-control', 'no-store');
  const { retryAfterS } = answer;
  if (retryAfterS !== undefined) reply.header('retry-after', String(retryAfterS));
  if (!isUnread(raw)) return reply.send(encoded);
  // The answer leaves at once; the connection ends when the rest of the body came, or a little later. [SV-45]
  const body = new PassThrough();
  body.write(encoded);
  void drain(raw, clock).then(() => body.end());
  return reply
    .header('connection', 'close')
    .header('content-length', Buffer.byteLength(encoded))
    .send(body);
}

function answerTo(
  { raw }: FastifyRequest,
  format: ServiceFormat,
  context: ServicesContext,
): Promise<ServiceAnswer> {
  const { callers, connectionGuard } = context;
  return answerRequest(
    {
      caller: callers.read(raw),
      connection: raw.socket,
      format,
      body: raw,
      declaredBytes: declaredLength(raw),
      encoding: raw.headers['content-encoding'],
      isAwaited: () => !raw.socket.readableEnded && !raw.socket.destroyed,
      onIdentified: (kind) => connectionGuard.of(raw.socket)?.handleCaller(kind),
    },
    context,
  );
}

/** Length of the body as its sender says it; undefined when it does not. */
function declaredLength({ headers }: IncomingMessage): number | undefined {
  if (headers['transfer-encoding'] !== undefined) return undefined;
  return Number(headers['content-length'] ?? 0);
}

function isUnread({ complete, headers }: IncomingMessage): boolean {
  const hasBody =
    headers['transfer-encoding'] !== undefined || Number(headers['content-length'] ?? 0) > 0;
  return hasBody && !complete;
}
