import type { Readable } from 'node:stream';
import { ServiceError } from '@ubii/proto';
import type { ServiceRequest } from '@ubii/proto';
import type { Clock } from '@ubii/timing';

import type { Limits } from '../../core/limits/index.ts';
import type { Master, ServiceAnswer } from '../../core/master/master.ts';
import type { CallerFacts } from '../../core/ports/index.ts';
import type { IncomingRequest } from '../../core/services/incoming-request.ts';
import type { BodyDecoder } from './bodies/body-decoder.ts';
import { BinaryBodyScan, JsonBodyScan } from './bodies/receive-body.ts';
import { receiveBody } from './bodies/receive-body.ts';
import type { ServiceFormat } from './service-format.ts';

export interface AnswerContext {
  readonly master: Pick<Master, 'openRequest' | 'handleServiceRequest' | 'refuseServiceRequest'>;
  readonly clock: Clock;
  readonly decoder: BodyDecoder;
  readonly limits: Pick<Limits, 'requestDepth' | 'bodyGraceMs' | 'bodyBytesPerSecond'>;
}

/** A request of which the transport knows everything but the body. */
export interface ArrivingRequest {
  readonly caller: CallerFacts;
  /** The same object for all requests of a connection. */
  readonly connection: object;
  readonly format: ServiceFormat;
  /** Paused: not a byte of it was read. */
  readonly body: Readable;
  /** Length of the body as its sender says it; undefined when it does not. */
  readonly declaredBytes: number | undefined;
  /** Encoding of the body, if the transport has such a thing. */
  readonly encoding?: string | undefined;
  /** Whether its sender still waits for the reply, if the transport knows. */
  readonly isAwaited?: () => boolean;
  /** Gets the caller, before the body is read. */
  readonly onIdentified: (kind: IncomingRequest['caller']['kind']) => void;
}

/** Reads and answers one request, over whatever transport: errors are in the reply. [SV-1] [SV-40] */
export async function answerRequest(
  arriving: ArrivingRequest,
  context: AnswerContext,
): Promise<ServiceAnswer> {
  const { master } = context;
  let incoming: IncomingRequest | undefined;
  try {
    incoming = master.openRequest(arriving.caller, arriving.connection);
    arriving.onIdentified(incoming.caller.kind);
    const request = await readRequest(arriving, incoming, context);
    if (arriving.isAwaited !== undefined) await requireSender(arriving.isAwaited);
    return await master.handleServiceRequest(request, arriving.caller, incoming);
  } catch (error) {
    // [SV-7]
    return master.refuseServiceRequest(error);
  } finally {
    incoming?.release();
  }
}

/**
 * While many clients come back at once, most requests that have arrived are of those that gave up waiting and have sent
 * another one: a master that answered all of them would have no time for the others. [SV-49]
 *
 * @throws ServiceError when nobody waits for the reply
 */
async function requireSender(isAwaited: () => boolean): Promise<void> {
  // What arrived together with the request, such as the end of its connection, is read before this resolves.
  await new Promise(setImmediate);
  if (!isAwaited())
    throw new ServiceError('unavailable', 'The connection of the request is closed.');
}

/** @throws ServiceError, DecodeError when it is too much, too slow or no request */
async function readRequest(
  { format, body: stream, declaredBytes, encoding }: ArrivingRequest,
  incoming: IncomingRequest,
  { clock, decoder, limits }: AnswerContext,
): Promise<ServiceRequest> {
  if (encoding !== undefined && encoding.toLowerCase() !== 'identity') {
    throw new ServiceError(
      'invalid_argument', // [SV-48]
      'The body of the request is compressed. Send it uncompressed, without the header Content-Encoding.',
    );
  }
  const scan =
    format.name === 'json' ? new JsonBodyScan(limits.requestDepth) : new BinaryBodyScan();
  // One by one: there are many limits, and copying all costs more than reading a small body.
  const { bodyGraceMs, bodyBytesPerSecond } = limits;
  const pace = { clock, bodyGraceMs, bodyBytesPerSecond };
  const body = await receiveBody({ stream, declaredBytes }, incoming, scan, pace);
  // The router refuses it, whatever the payload is. [SV-41]
  if (body.bytes === undefined) return { topic: body.topic };
  const request = await decoder.decode(body, format.name, incoming.account);
  if (request.topic !== body.topic) {
    // The limits that were kept were those of another service.
    throw new ServiceError('invalid_argument', 'The topic of the request cannot be decoded.');
  }
  return request;
}
