import { ServiceError, type ServiceInfo, type ServiceRequest } from '@ubii/proto';
import type { Caller } from '../access/caller.ts';
import type { Core } from '../areas/core.ts';
import type { Client } from '../clients/client.ts';
import { LIMITS } from '../limits/index.ts';
import type { ServiceAnswer } from './service-answer.ts';
import type { CallerFacts } from '../ports/caller-facts.ts';
import { boundTexts } from '../texts/bound-texts.ts';
import { quote } from '../texts/quote.ts';
import { forward, requireHere } from './forward.ts';
import { findService } from './all-services.ts';
import { openAuditOf, writeResult } from './audit.ts';
import type { Service } from './define-service.ts';
import type { ServiceCall } from './service-call.ts';

/** A call that works longer than this gives others a turn, milliseconds. A frame of an animation is 16. */
const MAX_TURN_MS = 8;

/**
 * Answers a request, whatever it holds; never rejects [SV-2].
 *
 * @param known who called, when that was found before the body was read
 */
export function answerRequest(
  core: Core,
  request: ServiceRequest,
  facts: CallerFacts,
  known?: Caller,
): Promise<ServiceAnswer> {
  core.counters.countRequest(request.topic);
  const call = new Call(core, facts, known);
  const { serviceTimeoutMs } = core.limits;
  return new Promise((resolve) => {
    const cancel = core.clock.after(serviceTimeoutMs, () => {
      const text = `The service ${quote(request.topic)} did not answer within ${serviceTimeoutMs} ms. Send the request again.`;
      resolve(refuse(core, new ServiceError('deadline_exceeded', text), call));
    });
    const answer = (answered: ServiceAnswer): void => {
      cancel();
      resolve(answered);
    };
    audited(core, request, call).then(answer, (error: unknown) =>
      answer(refuse(core, error, call)),
    );
  });
}

/** The answer to a request that cannot be fulfilled. The one place where errors meet the wire [SV-5]. */
export function refuse(core: Core, thrown: unknown, call?: Call): ServiceAnswer {
  const error = ServiceError.from(thrown);
  core.counters.failedRequests++;
  core.counters.refused[error.code]++;
  if (error.code === 'internal') {
    core.log.error('a service request failed', {
      reason: String(thrown),
      stack: thrown instanceof Error ? thrown.stack : undefined,
    });
  }
  const { retryAfterS } = error.details;
  return {
    reply: { error: error.toWire() },
    afterReply: () => call?.finish(),
    ...(typeof retryAfterS === 'number' && { retryAfterS }),
  };
}

/**
 * Handles a request, and writes its result to the audit log if the service is audited [EX-90]. What another master
 * is to answer, that master writes into its own.
 */
async function audited(core: Core, request: ServiceRequest, call: Call): Promise<ServiceAnswer> {
  const service = findService(request.topic);
  const answered = service && forwarded(core, service, request, call);
  if (answered !== undefined) return answered;
  const write = openAuditOf(core, service, request, call);
  return writeResult(write, () => handle(core, service, request, call));
}

/** The answer of another master; undefined: it is this one's. [CU-28] */
function forwarded(
  core: Core,
  service: Service,
  request: ServiceRequest,
  call: Call,
): Promise<ServiceAnswer> | undefined {
  if (core.masters === undefined || call.isOfMaster) return undefined;
  // Requests of callers without the right are not forwarded.
  core.access.authorize(call.caller, service, request.topic, service.subjectOf(request));
  return forward(core, service, request, call.facts)?.then((reply) => ({
    reply,
    afterReply: () => call.finish(),
  }));
}

async function handle(
  core: Core,
  service: Service | undefined,
  request: ServiceRequest,
  call: Call,
): Promise<ServiceAnswer> {
  if (service === undefined) throw unknownService(request.topic);
  const actsFor = service.subjectOf(request);
  const client = actsFor === undefined ? undefined : core.clients.get(actsFor);
  if (call.isOfMaster) requireHere(core, service, request);
  core.access.authorize(call.caller, service, request.topic, actsFor);
  requirePayload(service.info, request);
  const bounded = withBoundTexts(core, request, client);
  if (service.isSignOfLife && client !== undefined && client.home === undefined) {
    if (core.access.mayActFor(call.caller, client.id)) core.clients.handleSign(client);
  }
  let reply = await service.handle(core, bounded, call);
  if (service.gather !== undefined && core.masters !== undefined && !call.isOfMaster) {
    reply = service.gather(reply, await core.masters.callAll(bounded, call.facts)); // [CU-29]
  }
  return { reply, afterReply: () => call.finish() };
}

/** @throws ServiceError when the request has no payload, and needs one [SV-6] */
function requirePayload(
  { topic, request: member, alternativeRequest, requestRequired, requestFormat }: ServiceInfo,
  request: ServiceRequest,
): void {
  const isGiven = [member, alternativeRequest].some(
    (one) => one !== undefined && request[one] !== undefined,
  );
  if (isGiven || !requestRequired) return;
  throw new ServiceError(
    'invalid_argument',
    `The service ${topic} needs the member ${member} (${requestFormat}), which the request does not have.`,
    { details: { member } },
  );
}

/**
 * The request with its texts as long as they may be.
 * @param subject the client for which the request is sent, if it is known
 * @throws ServiceError when one is refused [EX-70]
 */
function withBoundTexts(
  { limits, limitWatch }: Core,
  request: ServiceRequest,
  subject: Client | undefined,
): ServiceRequest {
  return boundTexts('ubii.services.ServiceRequest', request, {
    limits,
    refuse({ member, limit, length }) {
      limitWatch.count(limit, subject?.id);
      const max = limits[limit];
      const { unit } = LIMITS[limit];
      return new ServiceError(
        'resource_exhausted',
        `The member ${member} has ${length} ${unit}; the maximum is ${max} (limit ${limit}). Send fewer.`,
        { details: { limit, max, member, length } },
      );
    },
  });
}

function unknownService(topic: string): ServiceError {
  if (topic === '') {
    return new ServiceError(
      'invalid_argument', // [SV-6]
      'The request has no topic. Set `topic` to a service, such as /services/service_list.',
    );
  }
  return new ServiceError(
    'unimplemented', // [SV-6]
    `This master has no service ${quote(topic)}. Call /services/service_list to list its services.`,
  );
}

/** One call on its way through its handler. */
class Call implements ServiceCall {
  readonly place: string;
  readonly address: string | undefined;
  readonly #core: Core;
  readonly facts: CallerFacts;
  #caller: Caller | undefined = undefined;
  #afterReply: (() => void)[] = [];
  #isFinished = false;
  #lastYieldMs: number;

  constructor(core: Core, facts: CallerFacts, known: Caller | undefined) {
    this.#core = core;
    this.facts = facts;
    // Admitted callers are identified again: their access may have been revoked while the body arrived.
    if (known?.kind === 'stranger') this.#caller = known;
    this.place = facts.place;
    this.address = facts.address;
    this.#lastYieldMs = core.clock.monotonicMs();
  }

  get isHere(): boolean {
    return this.facts.isHere && !this.isOfMaster;
  }

  get isOfMaster(): boolean {
    return this.facts.calledMaster !== undefined;
  }

  /** Found once: a wrong code counts once. */
  get caller(): Caller {
    return (this.#caller ??= this.#core.access.identify(this.facts));
  }

  afterReply(fn: () => void): void {
    // A handler that was too late has no reply to wait for.
    if (this.#isFinished) fn();
    else this.#afterReply.push(fn);
  }

  yieldToEventLoop(): Promise<void> | undefined {
    const { clock } = this.#core;
    if (clock.monotonicMs() - this.#lastYieldMs < MAX_TURN_MS) return undefined;
    return new Promise((resolve) => {
      clock.after(0, () => {
        this.#lastYieldMs = clock.monotonicMs();
        resolve();
      });
    });
  }

  finish(): void {
    this.#isFinished = true;
    const fns = this.#afterReply;
    this.#afterReply = [];
    for (const fn of fns) fn();
  }
}
