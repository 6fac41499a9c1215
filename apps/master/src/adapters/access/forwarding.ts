import type { IncomingHttpHeaders } from 'node:http';
import { isIP } from 'node:net';

import { plainAddress } from '../addresses/address-kinds.ts';

/**
 * Headers with which proxies and tunnels mark forwarded requests, by what their
 * names have in common: new ones follow the habit. Those of browsers and programs are none of them. [AC-1]
 */
// eslint-disable-next-line ubii/no-native-patterns -- alternatives of words, without repetitions
const FORWARDING = new RegExp(
  [
    'forward',
    // Also `proxy-connection`: a client that sends it was told to use a proxy.
    'prox(y|ied)',
    '^via$',
    '^x-original-',
    '^x-real-',
    '^x-remote-',
    '^remote-',
    '(^|-)(client|connecting|cluster|peer|source|user|end-?user|visitor|true)-?(ip|addr(ess)?|port)$',
    '-clientip$',
    '^x-(host|scheme)$',
    '-https$',
    '(^|-)(ssl|tls|client-cert)(-|$)',
    '^(x-)?(cf|cdn|fastly|fly|akamai|tailscale|ngrok|incap|coder|github)-',
    '^x-(sucuri|arr|envoy|amzn?|azure|ms|appengine|goog|vercel|nf|varnish|cluster|authentik|auth-request)-',
    '^x-varnish$',
  ].join('|'),
);

/** Maximum number of addresses in a chain. */
const MAX_HOPS = 32;

/** True when a header marks the request as forwarded. */
export function isPassedOn(headers: IncomingHttpHeaders): boolean {
  for (const name in headers) if (FORWARDING.test(name)) return true;
  return false;
}

/**
 * Returns the caller behind a trusted proxy: the last address of the chain that is not a trusted proxy.
 * Addresses before it were set by that caller. [AC-41]
 *
 * @returns undefined when the header is missing or ambiguous
 */
export function callerBehind(
  headers: IncomingHttpHeaders,
  isTrustedProxy: (address: string) => boolean,
): string | undefined {
  const chain = chainOf(headers);
  for (const hop of chain?.slice(-MAX_HOPS).reverse() ?? []) {
    const address = addressOf(hop);
    if (address === undefined || !isTrustedProxy(address)) return address;
  }
  return undefined;
}

/** Addresses of the proxies that forwarded the request, nearest last; undefined when two headers have them, or none. */
function chainOf(headers: IncomingHttpHeaders): readonly string[] | undefined {
  const { forwarded } = headers;
  const list = headers['x-forwarded-for'];
  // One of the two may be what a stranger wrote and a proxy left as it was.
  if ((forwarded === undefined) === (list === undefined)) return undefined;
  if (list !== undefined) return String(list).split(',');
  return String(forwarded)
    .split(',')
    .map((element) => {
      const [node, ...more] = element
        .split(';')
        .flatMap((pair) => /^\s*for\s*=\s*(.*?)\s*$/i.exec(pair)?.[1] ?? []);
      return more.length > 0 ? '' : (node ?? '').replace(/^"(.*)"$/, '$1');
    });
}

/** `10.0.0.7`, `10.0.0.7:80`, `fd00::7`, `[fd00::7]:80`; undefined for names and what is hidden. */
function addressOf(hop: string): string | undefined {
  const text = hop.trim();
  const bracketed = /^\[([^\]]*)\](?::\d{1,5})?$/.exec(text)?.[1];
  const plain = bracketed ?? (text.includes('.') ? text.replace(/:\d{1,5}$/, '') : text);
  return isIP(plain) === 0 ? undefined : plainAddress(plain);
}
