import { ServiceError, type ServiceErrorOptions } from '@ubii/proto';
import type { Access } from '../access/access.ts';
import type { Caller } from '../access/caller.ts';
import type { LimitName, Limits } from '../limits/index.ts';
import type { CallerFacts } from '../ports/caller-facts.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { BodyAccounts, BodyCharge } from '../connections/body-accounts.ts';
import { findService } from './all-services.ts';
import { bodyLimitsOf, largestBodyLimits, type BodyLimits } from './body-limits.ts';
import type { Service } from './define-service.ts';

export interface IncomingContext {
  readonly limits: Limits;
  readonly limitWatch: LimitWatch;
  readonly access: Access;
  readonly bodies: BodyAccounts;
}

/** A request after its headers: its caller, and the limits of its body [SV-40]. */
export class IncomingRequest {
  /** Found once: a wrong code counts once. */
  readonly caller: Caller;
  readonly #context: IncomingContext;
  readonly #charge: BodyCharge;
  readonly #largest: BodyLimits;

  constructor(context: IncomingContext, facts: CallerFacts, connection: object) {
    this.#context = context;
    this.caller = context.access.identify(facts);
    this.#charge = context.bodies.open(this.caller, facts.place, connection);
    this.#largest = this.#ofCaller(largestBodyLimits(context.limits));
  }

  /** The same text for all requests that share what one caller may have. */
  get account(): string {
    return this.#charge.account;
  }

  /** Limits of the largest request this caller may send. */
  get largest(): BodyLimits {
    return this.#largest;
  }

  /**
   * Limits on the body of a request to a service.
   *
   * @returns undefined when this caller may not call it or there is none, whatever the payload
   */
  limitsOf(topic: string): BodyLimits | undefined {
    const service = findService(topic);
    if (service === undefined || !this.#mayCall(service)) return undefined;
    return this.#ofCaller(bodyLimitsOf(this.#context.limits, service.info));
  }

  /** Takes room for a body of so many bytes. @throws ServiceError when there is none [SV-46] */
  reserve(bytes: number): void {
    this.#charge.reserve(bytes);
  }

  /** Gives the room back: the body is no longer kept. May be called more than once. */
  release(): void {
    this.#charge.release();
  }

  /** The error for a body with too many bytes. */
  tooManyBytes({ bytes, bytesLimit }: BodyLimits, given: string): ServiceError {
    return this.#refusal(
      bytesLimit,
      `A request has at most ${bytes} bytes here (limit ${bytesLimit}), but this one has ${given}. Send less in one request.`,
    );
  }

  /** The error for a body with too many values. @param atByte where the first one too many is */
  tooManyValues({ values, valuesLimit }: BodyLimits, atByte: number): ServiceError {
    return this.#refusal(
      valuesLimit,
      `A request has at most ${values} values here (limit ${valuesLimit}), which is exceeded at byte ${atByte}. Send less in one request.`,
    );
  }

  /** The error for a body that nests too deep. @param atByte where it does */
  tooDeep(atByte: number): ServiceError {
    const { requestDepth } = this.#context.limits;
    return this.#refusal(
      'requestDepth',
      `A request has at most ${requestDepth} objects and lists within each other (limit requestDepth), which is exceeded at byte ${atByte}. Reduce the nesting.`,
    );
  }

  /** The error for a body that comes too slowly [SV-47]. */
  tooSlow(bytes: number, seconds: number): ServiceError {
    const { bodyBytesPerSecond } = this.#context.limits;
    this.#count('bodyBytesPerSecond');
    return new ServiceError(
      'deadline_exceeded',
      `Only ${bytes} bytes of the request arrived in ${seconds} s; the minimum is ${bodyBytesPerSecond} bytes per second (limit bodyBytesPerSecond). Send the request again over a faster connection.`,
    );
  }

  #mayCall(service: Service): boolean {
    try {
      this.#context.access.authorize(this.caller, service, service.info.topic, undefined);
      return true;
    } catch {
      return false;
    }
  }

  #ofCaller(service: BodyLimits): BodyLimits {
    const { kind } = this.caller;
    if (kind !== 'stranger' && kind !== 'joining') return service;
    const bytesLimit = kind === 'stranger' ? 'strangerBodyBytes' : 'joiningBodyBytes';
    const bytes = this.#context.limits[bytesLimit];
    return bytes < service.bytes ? { ...service, bytes, bytesLimit } : service;
  }

  /** Callers that have not joined get that error first, with the reason: they can correct it. */
  #refusal(limit: LimitName, message: string): ServiceError {
    this.#count(limit);
    const details = { limit, max: this.#context.limits[limit] };
    const { caller } = this;
    if (caller.kind !== 'stranger') {
      return new ServiceError('resource_exhausted', message, { details });
    }
    const { code, message: reason, title } = caller.refusal;
    const options: ServiceErrorOptions = {
      title,
      details: { ...caller.refusal.details, ...details },
    };
    return new ServiceError(code, `${reason} ${message}`, options);
  }

  #count(limit: LimitName): void {
    const { caller } = this;
    this.#context.limitWatch.count(limit, caller.kind === 'client' ? caller.clientId : undefined);
  }
}
