import type { ClientActivity } from '@ubii/proto';
import type { ChartPoint } from '../../ui/charts/with-gaps.ts';

/** Time span of a client's traffic chart, milliseconds. */
export const TRAFFIC_MS = 5 * 60_000;
/** Number of reports kept: slightly more than arrive in that time. */
const SLOTS = 450;

/** Sent and received records per second of a client, oldest first. */
export interface Traffic {
  readonly sends: readonly ChartPoint[];
  readonly gets: readonly ChartPoint[];
}

/**
 * Rates of all clients at the last reports, in rings with shared times: a report adds two numbers per client, and
 * points are created only for the selected client.
 */
export class TrafficHistory {
  readonly #times = new Float64Array(SLOTS);
  readonly #rings = new Map<
    string,
    { readonly sends: Float32Array; readonly gets: Float32Array }
  >();
  #count = 0;

  /** @param timeMs time of the report; earlier or equal ones are ignored */
  add(timeMs: number, activities: Iterable<ClientActivity>): void {
    if (this.#count > 0 && timeMs <= this.#times[(this.#count - 1) % SLOTS]!) return;
    const slot = this.#count % SLOTS;
    this.#times[slot] = timeMs;
    this.#count += 1;
    const gone = new Set(this.#rings.keys());
    for (const { clientId, recordsInPerSecond, recordsOutPerSecond } of activities) {
      gone.delete(clientId);
      const ring = this.#rings.get(clientId) ?? this.#begin(clientId);
      ring.sends[slot] = recordsInPerSecond;
      ring.gets[slot] = recordsOutPerSecond;
    }
    for (const id of gone) this.#rings.delete(id);
  }

  of(clientId: string): Traffic {
    const ring = this.#rings.get(clientId);
    return { sends: this.#points(ring?.sends), gets: this.#points(ring?.gets) };
  }

  #begin(clientId: string): { sends: Float32Array; gets: Float32Array } {
    // NaN before the client existed, which differs from a rate of 0.
    const ring = {
      sends: new Float32Array(SLOTS).fill(NaN),
      gets: new Float32Array(SLOTS).fill(NaN),
    };
    this.#rings.set(clientId, ring);
    return ring;
  }

  #points(values: Float32Array | undefined): ChartPoint[] {
    const points: ChartPoint[] = [];
    if (values === undefined) return points;
    const newestMs = this.#times[(this.#count - 1) % SLOTS]!;
    for (let i = Math.max(0, this.#count - SLOTS); i < this.#count; i++) {
      const timeMs = this.#times[i % SLOTS]!;
      const value = values[i % SLOTS]!;
      if (newestMs - timeMs <= TRAFFIC_MS && !Number.isNaN(value)) points.push({ timeMs, value });
    }
    return points;
  }
}
