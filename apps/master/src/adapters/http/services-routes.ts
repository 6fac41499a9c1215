import type { FastifyInstance, FastifyReply, FastifyRequest } from 'fastify';
import { ServiceError } from '@ubii/proto';

import type { Master, ServiceAnswer } from '../../core/master.ts';
import { readBody } from './read-body.ts';
import { binaryFormat, formatOf, jsonFormat } from './service-format.ts';
import type { ServiceFormat } from './service-format.ts';

/** A body as the parser leaves it; requests without one have null. */
type Body = { readonly bytes: Buffer | undefined } | null;

export interface ServicesOptions {
  readonly master: Pick<Master, 'handleServiceRequest' | 'refuseServiceRequest'>;
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

  const serve = async (request: FastifyRequest, reply: FastifyReply, format: ServiceFormat) => {
    const answer = await answerTo(request.body as Body, format, options);
    // What waits for the reply may follow once it left, or once its receiver did. [TD-24]
    reply.raw.once('close', () => answer.afterReply());
    if (isTooLarge(request.body as Body)) reply.header('connection', 'close');
    return reply
      .header('content-type', format.contentType)
      .header('cache-control', 'no-store')
      .send(format.encodeReply(answer.reply));
  };
  app.post('/services/json', (request, reply) => serve(request, reply, jsonFormat));
  app.post('/services/binary', (request, reply) => serve(request, reply, binaryFormat));
  app.post('/services', (request, reply) =>
    serve(request, reply, formatOf(request.headers['content-type'])),
  );
}

async function answerTo(
  body: Body,
  format: ServiceFormat,
  { master, maxRequestBytes }: ServicesOptions,
): Promise<ServiceAnswer> {
  if (isTooLarge(body)) {
    const message = `A service request may have at most ${maxRequestBytes} bytes: send less at once.`;
    return master.refuseServiceRequest(new ServiceError('resource_exhausted', message));
  }
  try {
    const request = format.decodeRequest(body?.bytes ?? new Uint8Array());
    return await master.handleServiceRequest(request);
  } catch (error) {
    // [SV-7]
    return master.refuseServiceRequest(error);
  }
}

function isTooLarge(body: Body): boolean {
  return body !== null && body.bytes === undefined;
}
