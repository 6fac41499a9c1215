/** WebSocket close codes of the topic-data channel, as docs/spec/extensions.md lists them. */
export const CLOSE = {
  /** Close code of a client that leaves permanently [EX-55]. */
  left: { code: 4000, reason: 'left' },
  goingAway: { code: 1001, reason: 'master is closing' },
  superseded: { code: 4001, reason: 'superseded' },
  notThisClient: { code: 4003, reason: 'not this client' },
  unknownClient: { code: 4004, reason: 'unknown client' },
  protocolErrors: { code: 4008, reason: 'protocol errors' },
  tooSlow: { code: 4009, reason: 'too slow' },
  disconnected: { code: 4010, reason: 'disconnected' },
  revoked: { code: 4011, reason: 'revoked' },
  expired: { code: 4012, reason: 'the invitation expired' },
  tooMany: { code: 4013, reason: 'too many' },
} as const;
