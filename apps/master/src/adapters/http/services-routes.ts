import type { FastifyInstance, FastifyReply, FastifyRequest } from 'fastify';
import { ServiceError } from '@ubii/proto';

import type { Master, ServiceAnswer } from '../../core/master.ts';
import type { CallerReader } from '../access/caller-reader.ts';
import { isRefusal } from './error-replies.ts';
import { readBody } from './read-body.ts';
import { binaryFormat, formatOf, jsonFormat } from './service-format.ts';
import type { ServiceFormat } from './service-format.ts';

/** A body as the parser leaves it: `bytes` is undefined when there were too many. */
type Body = { readonly bytes: Buffer | undefined } | null | undefined;

export interface ServicesOptions {
  readonly master: Pick<Master, 'handleServiceRequest' | 'refuseServiceRequest'>;
  readonly callers: Pick<CallerReader, 'read'>;
  /** Largest request. */
  readonly maxRequestBytes: number;
}

/** Services over HTTP: always status 200 with a reply, errors included. [SV-1] */
export function addServices(app: FastifyInstance, options: ServicesOptions): void {
  const { maxRequestBytes } = options;
  // Whatever a client calls its content, the path says what it is.
  app.removeAllContentTypeParsers();
  app.addContentTypeParser(
    '*',
    async (_request: FastifyRequest, payload: FastifyRequest['raw']) => ({
      bytes: await readBody(payload, maxRequestBytes),
    }),
  );

  const addRoute = (path: string, formatFor: (request: FastifyRequest) => ServiceFormat): void => {
    app.post(path, {
      handler: async (request, reply) => {
        const format = formatFor(request);
        const body = request.body as Body;
        if (isTooLarge(body)) reply.header('connection', 'close');
        return send(reply, format, await answerTo(request, format, options));
      },
      // The framework refuses some requests on its own, for a header it cannot read. [SV-1]
      errorHandler: (error, request, reply) => {
        if (ServiceError.from(error).code === 'permission_denied') throw error;
        const refusal = isRefusal(error)
          ? new ServiceError('invalid_argument', error.message)
          : error;
        const answer = options.master.refuseServiceRequest(refusal);
        void send(reply.code(200), formatFor(request), answer);
      },
    });
  };
  addRoute('/services/json', () => jsonFormat);
  addRoute('/services/binary', () => binaryFormat);
  addRoute('/services', ({ headers }) => formatOf(headers['content-type']));
}

function send(reply: FastifyReply, format: ServiceFormat, answer: ServiceAnswer): FastifyReply {
  // What waits for the reply may follow once it left, or once its receiver did. [TD-24]
  reply.raw.once('close', () => answer.afterReply());
  return reply
    .header('content-type', format.contentType)
    .header('cache-control', 'no-store')
    .send(format.encodeReply(answer.reply));
}

async function answerTo(
  { raw, body: unread }: FastifyRequest,
  format: ServiceFormat,
  { master, callers, maxRequestBytes }: ServicesOptions,
): Promise<ServiceAnswer> {
  const body = unread as Body;
  if (isTooLarge(body)) {
    const message = `A service request may have at most ${maxRequestBytes} bytes: send less at once.`;
    return master.refuseServiceRequest(new ServiceError('resource_exhausted', message));
  }
  try {
    const request = format.decodeRequest(body?.bytes ?? new Uint8Array());
    return await master.handleServiceRequest(request, callers.read(raw));
  } catch (error) {
    // [SV-7]
    return master.refuseServiceRequest(error);
  }
}

function isTooLarge(body: Body): boolean {
  return body != null && body.bytes === undefined;
}
