import type { IncomingHttpHeaders } from 'node:http';
import { isIP } from 'node:net';

import type { CallerFacts, CallerStanding } from '../../core/ports/index.ts';
import { isLoopbackHost, plainAddress } from '../network/address-kinds.ts';
import type { OriginPolicy } from '../network/origin-policy.ts';

/** What is looked at of a request. */
export interface CallerRequest {
  readonly headers: IncomingHttpHeaders;
  readonly httpVersion?: string;
  readonly socket: { readonly remoteAddress?: string | undefined };
}

export interface CallerReaderOptions {
  readonly policy: Pick<OriginPolicy, 'isOfThisMachine'>;
  /** Whether an address is one of this machine. */
  readonly isOwnAddress: (address: string) => boolean;
  /** Whether an address is of a network that is let in without a token. */
  readonly isLegacyAddress: (address: string) => boolean;
}

/**
 * Headers by which proxies and tunnels say that they pass on the request of somebody else: whoever
 * connects from this machine with one of them brings a stranger. [AC-1]
 */
const PROXY_HEADERS = [
  'forwarded',
  'via',
  'x-forwarded-for',
  'x-forwarded-host',
  'x-forwarded-proto',
  'x-forwarded-port',
  'x-forwarded-server',
  'x-original-forwarded-for',
  'x-original-host',
  'x-real-ip',
  'x-client-ip',
  'x-cluster-client-ip',
  'x-envoy-external-address',
  'true-client-ip',
  'client-ip',
  'cf-connecting-ip',
  'cf-ray',
  'fastly-client-ip',
  'fly-client-ip',
  'x-azure-clientip',
  'tailscale-user-login',
] as const;

/** Nothing of ours is longer; what is, is good for nothing and not looked at. */
const MAX_BEARER_LENGTH = 1_024;

/** Reads from a request who calls, the same for services and sockets on every port. [AC-6] */
export class CallerReader {
  readonly #options: CallerReaderOptions;

  constructor(options: CallerReaderOptions) {
    this.#options = options;
  }

  read({ headers, socket, httpVersion }: CallerRequest): CallerFacts {
    const address = plainAddress(socket.remoteAddress);
    return {
      // Proxies that say nothing of whom they serve speak HTTP/1.0 by default; programs of today do not.
      standing: httpVersion === '1.0' ? 'other' : this.#standingOf(address, headers),
      place: placeOf(address),
      bearer: bearerOf(headers.authorization),
    };
  }

  #standingOf(address: string | undefined, headers: IncomingHttpHeaders): CallerStanding {
    // A connection that is gone already has none.
    if (address === undefined || isPassedOn(headers)) return 'other';
    const { policy, isOwnAddress, isLegacyAddress } = this.#options;
    if (isLoopbackHost(address) || isOwnAddress(address)) {
      return policy.isOfThisMachine(headers) ? 'local' : 'other';
    }
    // Browsers say which page asks; existing pages of other machines come with the operator's leave.
    return isLegacyAddress(address) ? 'network' : 'other';
  }
}

function isPassedOn(headers: IncomingHttpHeaders): boolean {
  for (const name of PROXY_HEADERS) if (headers[name] !== undefined) return true;
  return false;
}

/** What follows `Bearer`; undefined for other ways to show who one is, which are not ours. [AC-3] */
function bearerOf(authorization: string | undefined): string | undefined {
  if (authorization === undefined) return undefined;
  const match = /^bearer(?: +(.*))?$/i.exec(authorization.trim());
  if (match === null) return undefined;
  const bearer = match[1]?.trim() ?? '';
  return bearer.length > MAX_BEARER_LENGTH ? '' : bearer;
}

/** Where wrong codes are counted: one person has 64 bits of IPv6 addresses. [AC-17] */
function placeOf(address: string | undefined): string {
  if (address === undefined || isIP(address) !== 6) return address ?? '';
  const [head = '', tail] = address.split('::');
  const groups = head === '' ? [] : head.split(':');
  const missing =
    tail === undefined ? 0 : 8 - groups.length - tail.split(':').filter(Boolean).length;
  return [...groups, ...Array<string>(Math.max(0, missing)).fill('0')].slice(0, 4).join(':');
}
