import { limit } from './limit.ts';

/** Limits of connections and of their requests. */
export const CONNECTION_LIMITS = {
  sockets: limit(
    10_000,
    'sockets',
    'storage',
    'Open topic-data sockets. Below the usual limit of file descriptors of a process (16 384 and more).',
  ),
  connections: limit(
    12_288,
    'connections',
    'storage',
    'Open connections to all ports. One eighth is reserved for local callers. At startup, reduced to half of the file descriptors of the process.',
  ),
  connectionsOfStrangers: limit(
    2_048,
    'connections',
    'storage',
    'The same limit for callers without a token, such as all phones of a large room that load the page at once. At most half of all connections.',
  ),
  connectionsPerAddress: limit(
    512,
    'connections',
    'storage',
    'HTTP connections from one remote address. A class of 60 phones behind one router loads its pages at once.',
  ),
  connectionsPerNetwork: limit(
    1_024,
    'connections',
    'storage',
    'The same limit for one IPv6 /64 network, because one machine can use all addresses of its network.',
  ),
  serviceTimeoutMs: limit(
    8_000,
    'ms',
    'time',
    'Time to answer a service request. Shorter than the request timeout of the clients of this repository, 10 s.',
  ),
  headersTimeoutMs: limit(
    10_000,
    'ms',
    'time',
    'Time for the first request of a connection, including the TLS handshake, and for the headers of each further request. A phone with weak Wi-Fi takes several seconds.',
  ),
} as const;
