import { decode, encode, ServiceError, type ClusterCall, type ClusterReply } from '@ubii/proto';
import type { Init, ServiceReply, ServiceRequest } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import type { Limits } from '../limits/index.ts';
import type { CalledMaster, CallerFacts, CallerStanding } from '../ports/caller-facts.ts';
import type { ProvenBus } from './proven-bus.ts';

/** Calls to other masters at once. */
const MAX_CALLS = 10_000;

const STANDINGS: readonly CallerStanding[] = ['trusted', 'local', 'network', 'other'];

/** Answers a request of a caller; never rejects. */
export type Answer = (
  request: ServiceRequest,
  facts: CallerFacts,
) => Promise<{ readonly reply: Init<ServiceReply>; afterReply(): void }>;

/** Dependencies of calls. */
export interface CallsContext {
  readonly clock: Clock;
  readonly limits: Limits;
  readonly bus: Pick<ProvenBus, 'send'>;
  /** Answers requests of other masters. */
  readonly answer: Answer;
}

interface Pending {
  readonly masterId: string;
  resolve(reply: ServiceReply): void;
  reject(error: ServiceError): void;
  readonly cancel: Cancel;
}

/** Service requests that another master answers. [CU-28] */
export class Calls {
  readonly #context: CallsContext;
  readonly #pending = new Map<number, Pending>();
  #number = 0;

  constructor(context: CallsContext) {
    this.#context = context;
  }

  /** @throws ServiceError when it cannot be reached, or does not answer in time */
  call(
    masterId: string,
    request: ServiceRequest,
    facts: CallerFacts,
    timeoutMs = this.#context.limits.serviceTimeoutMs,
  ): Promise<ServiceReply> {
    if (this.#pending.size >= MAX_CALLS) {
      const text = 'Too many requests wait for answers of other masters. Send the request again.';
      return Promise.reject(new ServiceError('resource_exhausted', text));
    }
    this.#number = (this.#number + 1) % 0x7fffffff;
    const number = this.#number;
    return new Promise((resolve, reject) => {
      const cancel = this.#context.clock.after(timeoutMs, () =>
        this.#fail(number, 'did not answer in time'),
      );
      this.#pending.set(number, { masterId, resolve, reject, cancel });
      this.#context.bus.send(masterId, { call: { number, ...encodeCall(request, facts) } });
    });
  }

  /** Settles the call that another master answers. @throws DecodeError when the reply cannot be read; the call fails in time */
  handleReply(from: string, { number, reply }: ClusterReply): void {
    const pending = this.#pending.get(number);
    if (pending?.masterId !== from) return;
    const decoded = decode('ubii.services.ServiceReply', reply);
    this.#end(number, pending);
    pending.resolve(decoded);
  }

  /** Answers a request of another master. @throws DecodeError when the request cannot be read */
  handleCall(from: CalledMaster, call: ClusterCall): void {
    const { answer, bus } = this.#context;
    const request = decode('ubii.services.ServiceRequest', call.request);
    void answer(request, factsOf(call, from)).then(({ reply, afterReply }) => {
      const bytes = encode('ubii.services.ServiceReply', reply);
      bus.send(from.id, { reply: { number: call.number, reply: bytes } });
      afterReply();
    });
  }

  /** A master is lost: it answers nothing any more. */
  handleLost(masterId: string): void {
    for (const [number, pending] of this.#pending) {
      if (pending.masterId === masterId) this.#fail(number, 'is lost');
    }
  }

  close(): void {
    for (const number of [...this.#pending.keys()]) this.#fail(number, 'was left');
  }

  #fail(number: number, what: string): void {
    const pending = this.#pending.get(number);
    if (pending === undefined) return;
    this.#end(number, pending);
    const text = `The master that has to answer this ${what}. Send the request again.`;
    pending.reject(new ServiceError('unavailable', text));
  }

  #end(number: number, { cancel }: Pending): void {
    cancel();
    this.#pending.delete(number);
  }
}

function encodeCall(
  request: ServiceRequest,
  { standing, place, address = '', bearer = '', isHere }: CallerFacts,
): Init<Omit<ClusterCall, 'number'>> {
  const bytes = encode('ubii.services.ServiceRequest', request);
  // A program of this machine is of the network for clients that are local to another one.
  const forwarded = standing === 'local' ? 'network' : standing;
  return { request: bytes, standing: forwarded, place, address, bearer, isHere };
}

/** What the other master says of the caller: it has judged its connection. */
function factsOf(
  { standing, place, address, bearer, isHere }: ClusterCall,
  calledMaster: CalledMaster,
): CallerFacts {
  return {
    calledMaster,
    standing: STANDINGS.find((one) => one === standing) ?? 'other',
    isHere,
    place,
    address: address || undefined,
    bearer: bearer || undefined,
  };
}
