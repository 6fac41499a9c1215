/** Facts of a message that a consumer delivers. */
export interface Delivery {
  /** Number of the message in its stream: the revision of a key. */
  readonly revision: number;
  /** Number of the message among those of its consumer, from 1. */
  readonly number: number;
  /** When it was stored, milliseconds since the Unix epoch. */
  readonly timeMs: number;
  /** Messages that are still to come. */
  readonly pending: number;
}

/**
 * Reads the reply subject of a delivered message: `$JS.ACK.<stream>.<consumer>.<deliveries>.<revision>.<number>.<time>.<pending>`,
 * in later servers with domain and account before the stream, and more behind (ADR-15 of NATS).
 *
 * @returns undefined for another text
 */
export function parseDelivery(reply: string): Delivery | undefined {
  const tokens = reply.split('.');
  if (tokens[0] !== '$JS' || tokens[1] !== 'ACK' || tokens.length < 9) return undefined;
  const at = tokens.length === 9 ? 5 : 7;
  const [revision, number, timeNs, pending] = tokens.slice(at, at + 4).map(Number);
  const isValid = [revision, number, timeNs, pending].every((each) => Number.isFinite(each));
  if (!isValid) return undefined;
  return {
    revision: revision!,
    number: number!,
    timeMs: Math.floor(timeNs! / 1e6),
    pending: pending!,
  };
}
