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

const NUMBER = String.raw`\d{1,13}(?:\.\d{1,6})?`;
// eslint-disable-next-line no-restricted-syntax -- of constants, without nested repetitions
const TIMED_PING = new RegExp(`^PING (\\d{1,10})(?: (-?${NUMBER}) (${NUMBER}) (-?${NUMBER}))?$`);

/** undefined for a text that is none. */
export function parseTimedPing(text: string): TimedPing | undefined {
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

/** @param receivedMs when the PING came; both times are epoch milliseconds with fractions */
export function formatTimedPong(number: string, receivedMs: number, sentMs: number): string {
  return `PONG ${number} ${receivedMs.toFixed(3)} ${sentMs.toFixed(3)}`;
}
