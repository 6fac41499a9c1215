import { messageDescriptor } from '../descriptor.ts';
import type { ServiceReply, ServiceRequest } from '../generated/messages.ts';

/** Member of `ServiceRequest` that carries a payload. */
export type RequestMember = Exclude<keyof ServiceRequest, 'topic'>;

/** Member of `ServiceReply` that carries the result of a success. */
export type ReplyMember = Exclude<keyof ServiceReply, 'error'>;

/** One service: the same entry serves the master, its clients and the service list. */
export interface ServiceInfo<
  Q extends RequestMember | undefined = RequestMember | undefined,
  P extends ReplyMember = ReplyMember,
  R extends boolean = boolean,
  A extends RequestMember | undefined = RequestMember | undefined,
> {
  readonly topic: string;
  /** Member of the request that carries the payload; undefined when it takes none. */
  readonly request: Q;
  /** Another member that is taken in its place. */
  readonly alternativeRequest: A;
  /** Whether a request without payload is refused. */
  readonly requestRequired: R;
  /** Member of the reply that is set on success. */
  readonly reply: P;
  /** Full message name of the payload; empty when it takes none. */
  readonly requestFormat: string;
  /** Full message name of the result. */
  readonly replyFormat: string;
  /** Purpose of the service, one sentence. */
  readonly description: string;
  /** Key in the constants every master sends with its configuration; undefined when it has none. */
  readonly constant: string | undefined;
  /** True for services that an original master does not have. */
  readonly isExtension: boolean;
}

interface Extras<A extends RequestMember | undefined> {
  readonly constant?: string;
  readonly alternativeRequest?: A;
}

/** A service that takes no payload. */
export function withoutPayload<P extends ReplyMember>(
  topic: string,
  reply: P,
  description: string,
  extras: Extras<undefined> = {},
): ServiceInfo<undefined, P, false, undefined> {
  return define(topic, undefined, false, reply, description, extras);
}

/** A service that needs a payload. */
export function withPayload<
  Q extends RequestMember,
  P extends ReplyMember,
  A extends RequestMember | undefined = undefined,
>(
  topic: string,
  request: Q,
  reply: P,
  description: string,
  extras: Extras<A> = {},
): ServiceInfo<Q, P, true, A> {
  return define(topic, request, true, reply, description, extras);
}

/** A service that can be asked with and without a payload. */
export function withOptionalPayload<
  Q extends RequestMember,
  P extends ReplyMember,
  A extends RequestMember | undefined = undefined,
>(
  topic: string,
  request: Q,
  reply: P,
  description: string,
  extras: Extras<A> = {},
): ServiceInfo<Q, P, false, A> {
  return define(topic, request, false, reply, description, extras);
}

function define<
  Q extends RequestMember | undefined,
  P extends ReplyMember,
  R extends boolean,
  A extends RequestMember | undefined,
>(
  topic: string,
  request: Q,
  requestRequired: R,
  reply: P,
  description: string,
  { constant, alternativeRequest }: Extras<A>,
): ServiceInfo<Q, P, R, A> {
  return {
    topic,
    request,
    alternativeRequest: alternativeRequest as A,
    requestRequired,
    reply,
    requestFormat: request === undefined ? '' : formatOf('ubii.services.ServiceRequest', request),
    replyFormat: formatOf('ubii.services.ServiceReply', reply),
    description,
    constant,
    isExtension: topic.startsWith('/services/ubii/'),
  };
}

function formatOf(message: string, member: string): string {
  const type = messageDescriptor(message).fieldByName.get(member)?.type;
  return typeof type === 'object' ? type.name : (type ?? '');
}
