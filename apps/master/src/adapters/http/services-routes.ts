import { PassThrough } from 'node:stream';
import type { IncomingMessage } from 'node:http';
import type { FastifyInstance, FastifyReply, FastifyRequest } from 'fastify';
import { ServiceError } from '@ubii/proto';
import type { ServiceRequest } from '@ubii/proto';
import type { Clock } from '@ubii/timing';

import type { Limits } from '../../core/limits/index.ts';
import type { Master, ServiceAnswer } from '../../core/master/master.ts';
import type { IncomingRequest } from '../../core/services/incoming-request.ts';
import type { CallerReader } from '../access/caller-reader.ts';
import type { Doorkeeper } from '../network/doorkeeper.ts';
import type { BodyDecoder } from './bodies/body-decoder.ts';
import { BinaryBodyScan, JsonBodyScan } from './bodies/body-scan.ts';
import { drain } from './bodies/drain.ts';
import { receiveBody } from './bodies/receive-body.ts';
import { isRefusal } from './error-replies.ts';
import { binaryFormat, formatOf, jsonFormat } from './service-format.ts';
import type { ServiceFormat } from './service-format.ts';

export interface ServicesOptions {
  readonly master: Pick<Master, 'openRequest' | 'handleServiceRequest' | 'refuseServiceRequest'>;
  readonly callers: Pick<CallerReader, 'read'>;
  readonly clock: Clock;
  readonly decoder: BodyDecoder;
  /** Is told whose connections are. */
  readonly doorkeeper: Pick<Doorkeeper, 'of'>;
  readonly limits: Pick<Limits, 'requestDepth' | 'bodyGraceMs' | 'bodyBytesPerSecond'>;
}

/** Services over HTTP: always status 200 with a reply, errors included. [SV-1] */
export function addServices(app: FastifyInstance, options: ServicesOptions): void {
  // Whatever a client calls its content, the path says what it is. Bodies are read by the handler,
  // which knows first who calls.
  app.removeAllContentTypeParsers();
  app.addContentTypeParser('*', (_request, _payload, done) => done(null));

  const addRoute = (path: string, formatFor: (request: FastifyRequest) => ServiceFormat): void => {
    app.post(path, {
      handler: async (request, reply) => {
        const format = formatFor(request);
        return send(request, reply, format, await answerTo(request, format, options), options);
      },
      // The framework refuses some requests on its own, for a header it cannot read. [SV-1]
      errorHandler: (error, request, reply) => {
        if (ServiceError.from(error).code === 'permission_denied') throw error;
        const refusal = isRefusal(error)
          ? new ServiceError('invalid_argument', error.message)
          : error;
        const answer = options.master.refuseServiceRequest(refusal);
        void send(request, reply.code(200), formatFor(request), answer, options);
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
  { clock }: ServicesOptions,
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

async function answerTo(
  { raw }: FastifyRequest,
  format: ServiceFormat,
  options: ServicesOptions,
): Promise<ServiceAnswer> {
  const { master, callers, doorkeeper } = options;
  let incoming: IncomingRequest | undefined;
  try {
    const caller = callers.read(raw);
    incoming = master.openRequest(caller, raw.socket);
    doorkeeper.of(raw.socket)?.handleCaller(incoming.caller.kind);
    const request = await readRequest(raw, format, incoming, options);
    return await master.handleServiceRequest(request, caller, incoming);
  } catch (error) {
    // [SV-7]
    return master.refuseServiceRequest(error);
  } finally {
    incoming?.release();
  }
}

/** @throws ServiceError, DecodeError when it is too much, too slow or no request */
async function readRequest(
  raw: IncomingMessage,
  format: ServiceFormat,
  incoming: IncomingRequest,
  { clock, decoder, limits }: ServicesOptions,
): Promise<ServiceRequest> {
  const encoding = raw.headers['content-encoding'];
  if (encoding !== undefined && encoding.toLowerCase() !== 'identity') {
    throw new ServiceError(
      'invalid_argument', // [SV-48]
      'The body of the request is compressed. Send it uncompressed, without the header Content-Encoding.',
    );
  }
  const scan =
    format.name === 'json' ? new JsonBodyScan(limits.requestDepth) : new BinaryBodyScan();
  const body = await receiveBody(raw, incoming, scan, { clock, ...limits });
  // The router refuses it, whatever the payload is. [SV-41]
  if (body.bytes === undefined) return { topic: body.topic };
  const request = await decoder.decode(body, format.name, incoming.account);
  if (request.topic !== body.topic) {
    // The limits that were kept were those of another service.
    throw new ServiceError('invalid_argument', 'The topic of the request cannot be decoded.');
  }
  return request;
}

function isUnread({ complete, headers }: IncomingMessage): boolean {
  const hasBody =
    headers['transfer-encoding'] !== undefined || Number(headers['content-length'] ?? 0) > 0;
  return hasBody && !complete;
}
