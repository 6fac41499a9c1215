/*
 * The heartbeat of a topic-data connection is text: PING asks, PONG answers [TD-2]. A PING with a number asks
 * for the time of the master as well [TS-2].
 */

/** Report of a client about its clock [TS-10]. */
export interface ToldClock {
  /** Master's clock minus the client's, milliseconds. */
  readonly offsetMs: number;
  readonly errorMs: number;
  readonly driftPpm: number;
}

/** A PING that asks for the master's time [TS-2]. */
export interface TimedPing {
  readonly number: string;
  readonly clock: ToldClock | undefined;
}

/** The answer to a `TimedPing`: times are epoch milliseconds with fractions. */
export interface TimedPong {
  readonly number: string;
  /** When the PING came. */
  readonly receivedMs: number;
  /** When the PONG leaves. */
  readonly sentMs: number;
}

/** What a text of the heartbeat says to the master. */
export type Heartbeat =
  | { readonly kind: 'ping'; readonly timed: TimedPing | undefined }
  | { readonly kind: 'pong' };

export const PING_TEXT = 'PING';
export const PONG_TEXT = 'PONG';

const NUMBER = String.raw`\d{1,13}(?:\.\d{1,6})?`;
// eslint-disable-next-line ubii/no-native-patterns -- of constants, without nested repetitions
const TIMED_PING = new RegExp(`^PING (\\d{1,10})(?: (-?${NUMBER}) (${NUMBER}) (-?${NUMBER}))?$`);
const PONG: Heartbeat = { kind: 'pong' };
const PLAIN_PING: Heartbeat = { kind: 'ping', timed: undefined };

/** Reads a text from a client. @returns undefined for one that is no heartbeat */
export function readHeartbeat(text: string): Heartbeat | undefined {
  if (text === PONG_TEXT) return PONG;
  if (text === PING_TEXT) return PLAIN_PING;
  const timed = text.startsWith(PING_TEXT) ? parseTimedPing(text) : undefined;
  return timed && { kind: 'ping', timed };
}

/** The text of a PONG, with the time if it is given. */
export function formatPong(timed?: TimedPong): string {
  if (timed === undefined) return PONG_TEXT;
  return `${PONG_TEXT} ${timed.number} ${timed.receivedMs.toFixed(3)} ${timed.sentMs.toFixed(3)}`;
}

/** Whether a binary message is the PONG that some existing clients send [TD-2]. */
export function isBinaryPong(bytes: Uint8Array): boolean {
  return (
    bytes.byteLength === 4 &&
    bytes[0] === 0x50 &&
    bytes[1] === 0x4f &&
    bytes[2] === 0x4e &&
    bytes[3] === 0x47
  );
}

function parseTimedPing(text: string): TimedPing | undefined {
  const [, number, offsetMs, errorMs, driftPpm] = TIMED_PING.exec(text) ?? [];
  if (number === undefined) return undefined;
  const clock =
    offsetMs === undefined
      ? undefined
      : {
          offsetMs: Number(offsetMs),
          errorMs: Number(errorMs),
          driftPpm: Number(driftPpm),
        };
  return { number, clock };
}
