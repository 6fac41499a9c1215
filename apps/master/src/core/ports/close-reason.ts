/**
 * Why the master ends the connection of a client, as docs/spec/extensions.md lists it. Each adapter says it in
 * the words of its transport.
 */
export const CLOSE_REASONS = [
  /** The client is removed, at its own request or for its absence [CL-16]. */
  'deregistered',
  'master is closing',
  /** Another connection of the client took its place [TD-7]. */
  'superseded',
  /** The token is missing or wrong [EX-4]. */
  'not this client',
  /** No client is registered with the id [TD-6]. */
  'unknown client',
  /** Too many messages that cannot be decoded [TD-18]. */
  'protocol errors',
  /** It took nothing for too long [TD-32]. */
  'too slow',
  /** A user removed the client [EX-30]. */
  'disconnected',
  /** The invitation of the client was revoked [AC-15]. */
  'revoked',
  /** The time of the invitation is over [AC-91]. */
  'expired',
  /** A limit on clients or connections. */
  'too many',
] as const;

export type CloseReason = (typeof CLOSE_REASONS)[number];

/** How a client ended its connection: it left permanently [EX-55], or the connection broke or was closed. */
export type ClientEnding = 'left' | 'lost';
