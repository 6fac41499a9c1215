import type { ClusterPart } from '@ubii/proto';

/** The members of a part that measure. */
export type PartTimes = Pick<ClusterPart, 'sentMs' | 'echoMs' | 'heldMs'>;

/**
 * Measures the time to another master and back, by times in the parts of both streams. Only times of one clock are
 * compared, as in NTP (RFC 5905, section 8). [CU-74]
 */
export class PeerRoundTrip {
  #received: { readonly sentMs: number; readonly receivedMs: number } | undefined = undefined;
  #latestMs = 0;

  /** The last measurement, milliseconds; 0 before the first. */
  get latestMs(): number {
    return this.#latestMs;
  }

  /** Times for a part that is sent now. @param nowMs monotonic milliseconds */
  times(nowMs: number): PartTimes {
    if (this.#received === undefined) return { sentMs: nowMs, echoMs: 0, heldMs: 0 };
    const { sentMs, receivedMs } = this.#received;
    return { sentMs: nowMs, echoMs: sentMs, heldMs: nowMs - receivedMs };
  }

  /** Times of a part that came now. Parts without times have zeros. */
  handleTimes({ sentMs, echoMs, heldMs }: PartTimes, nowMs: number): void {
    if (sentMs !== 0) this.#received = { sentMs, receivedMs: nowMs };
    if (echoMs !== 0) this.#latestMs = Math.max(0, nowMs - echoMs - heldMs);
  }
}
