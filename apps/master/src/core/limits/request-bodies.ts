import { KIB, MIB, limit } from './limit.ts';

/** Limits of the bodies of service requests. */
export const REQUEST_BODY_LIMITS = {
  strangerBodyBytes: limit(
    16 * KIB,
    'bytes',
    'messages',
    'Body of a service request from a caller that has not joined. Such callers only check a token and request the configuration: some hundred bytes.',
  ),
  joiningBodyBytes: limit(
    1 * MIB,
    'bytes',
    'messages',
    'Body of a service request from a caller with a token or code that is not registered yet. A registration with devices and small modules fits.',
  ),
  serviceBodyBytes: limit(
    256 * KIB,
    'bytes',
    'messages',
    'Body of an ordinary service request. For sessions, modules and registrations: 1.5 times `sessionBytes` or `registrationBytesPerClient`, because JSON is longer than the encoded form.',
  ),
  subscriptionBodyBytes: limit(
    4 * MIB,
    'bytes',
    'messages',
    'Body of a request to subscribe or unsubscribe: `listElements` topics of 200 bytes.',
  ),
  bodyBytes: limit(
    128 * MIB,
    'bytes',
    'queues',
    'Bytes of all service requests that are received or decoded. Local callers and remote callers can each use three quarters.',
  ),
  bodyBytesOfStrangers: limit(
    4 * MIB,
    'bytes',
    'queues',
    'The same limit for all callers that have not joined. Enough for 256 of their largest requests.',
  ),
  bodyBytesOfJoining: limit(
    16 * MIB,
    'bytes',
    'queues',
    'The same limit for all callers with a token or code that are not registered yet.',
  ),
  bodyBytesPerAddress: limit(
    2 * MIB,
    'bytes',
    'queues',
    'The same limit for unregistered callers from one address. Enough for 60 phones behind one router that register at once.',
  ),
  bodyBytesPerClient: limit(
    24 * MIB,
    'bytes',
    'queues',
    'The same limit for one client, or for one address that needs no token. Enough for two of the largest sessions.',
  ),
  bodyBytesPerConnection: limit(
    16 * MIB,
    'bytes',
    'queues',
    'The same limit for one connection. Existing clients send one request at a time.',
  ),
  bodyGraceMs: limit(
    10_000,
    'ms',
    'time',
    'Time after which the body of a service request must arrive at `bodyBytesPerSecond` or faster. Small bodies must be complete by then.',
  ),
  bodyBytesPerSecond: limit(
    32 * KIB,
    'bytes/s',
    'rates',
    'Lowest rate of the body of a service request. A weak mobile connection is several times faster.',
  ),
} as const;
