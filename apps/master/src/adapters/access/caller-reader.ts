import type { IncomingHttpHeaders } from 'node:http';

import type { CallerFacts, CallerStanding } from '../../core/ports/index.ts';
import { isLoopbackHost, placeOf, plainAddress } from '../addresses/address-kinds.ts';
import type { OriginPolicy } from '../network/origin-policy.ts';
import { bearerOf } from './bearer.ts';
import { callerBehind, isPassedOn } from './forwarding.ts';
import type { PeerOwners, PeerSocket } from './peer-owners.ts';

/** Parts of a request that identify its caller. */
export interface CallerRequest {
  readonly headers: IncomingHttpHeaders;
  readonly httpVersion?: string;
  readonly socket: PeerSocket;
  /** It shows the resume token of a client of this machine: the user of its program need not be known. [AC-27] */
  readonly isProven?: boolean;
}

/** Role of callers on this computer without a token. [AC-40] */
export interface LoopbackFacts {
  readonly role: 'admin' | 'participant' | 'none';
  /** The system tells programs of the operator's user from those of others. */
  readonly tellsOwners: boolean;
}

export interface CallerReaderContext {
  readonly policy: Pick<OriginPolicy, 'pageOf'>;
  /** Role of callers on this computer without a token. */
  readonly loopback: LoopbackFacts['role'];
  /** Whether an address is one of this machine. */
  readonly isOwnAddress: (address: string) => boolean;
  /** Whether an address is of a network that is admitted without a token. */
  readonly isLegacyAddress: (address: string) => boolean;
  /** Whether an address is of a proxy that may speak for others. */
  readonly isTrustedProxy: (address: string) => boolean;
  readonly owners: Pick<PeerOwners, 'isOperators' | 'learn'>;
}

/** The place of a caller, without pages and tokens of the request. */
type Whereabouts = Pick<CallerFacts, 'standing' | 'isHere'> & {
  readonly address: string | undefined;
  /** A proxy at the address forwarded the request of an unknown caller. */
  readonly isUnknown?: boolean;
};

/** Identifies the caller of a request, the same for services and sockets on every port. [AC-6] */
export class CallerReader {
  readonly #context: CallerReaderContext;

  constructor(context: CallerReaderContext) {
    this.#context = context;
  }

  /**
   * Finds out what `read` has to know, where that takes time. To be awaited before a request is read.
   *
   * @returns undefined when nothing has to be waited for; the promise is never rejected
   */
  prepare({ headers, socket, httpVersion, isProven }: CallerRequest): Promise<void> | undefined {
    if (isProven === true) return undefined;
    const address = plainAddress(socket.remoteAddress);
    if (address === undefined || httpVersion === '1.0' || isPassedOn(headers)) return undefined;
    return this.#isThisMachine(address) ? this.#context.owners.learn(socket) : undefined;
  }

  read(request: CallerRequest): CallerFacts {
    const { address, standing, isHere, isUnknown } = this.#whereaboutsOf(request);
    const bearer = bearerOf(request.headers.authorization);
    const place = placeOf(address);
    // Strangers behind a proxy do not use the quota of the caller at that address.
    if (isUnknown === true) return { standing, isHere, place: `behind ${place}`, bearer };
    return { standing, isHere, place, address, bearer };
  }

  #whereaboutsOf({ headers, socket, httpVersion, isProven }: CallerRequest): Whereabouts {
    const { isLegacyAddress, isTrustedProxy, owners } = this.#context;
    const address = plainAddress(socket.remoteAddress);
    const elsewhere: Whereabouts = { address, standing: 'other', isHere: false };
    // A connection that is gone already has none.
    if (address === undefined) return elsewhere;
    const isProxy = isTrustedProxy(address);
    if (isPassedOn(headers)) {
      const caller = isProxy ? callerBehind(headers, isTrustedProxy) : undefined;
      if (caller === undefined) return { ...elsewhere, isUnknown: true };
      // Never of this machine: that one passed nothing on. [AC-41]
      const isLegacy = isLegacyAddress(caller);
      return { address: caller, standing: isLegacy ? 'network' : 'other', isHere: false };
    }
    // Proxies that say nothing of whom they serve speak HTTP/1.0 by default; programs of today do not.
    if (httpVersion === '1.0') return { ...elsewhere, isUnknown: true };
    if (this.#isThisMachine(address)) {
      const isOurs = isProven === true || owners.isOperators(socket);
      if (!isOurs) return { ...elsewhere, isUnknown: true };
      const standing = isProxy ? 'other' : this.#localStanding(headers);
      return { address, standing, isHere: true };
    }
    // Browsers say which page asks; existing pages of other machines come with the operator's leave.
    const isLegacy = !isProxy && isLegacyAddress(address);
    return isLegacy ? { ...elsewhere, standing: 'network' } : elsewhere;
  }

  #isThisMachine(address: string): boolean {
    return isLoopbackHost(address) || this.#context.isOwnAddress(address);
  }

  /** On this machine, without a proxy: the page decides. [AC-2] [AC-40] */
  #localStanding(headers: IncomingHttpHeaders): CallerStanding {
    const { policy, loopback } = this.#context;
    const page = policy.pageOf(headers);
    if (page === 'foreign' || loopback === 'none') return 'other';
    return page === 'own' && loopback === 'admin' ? 'trusted' : 'local';
  }
}
