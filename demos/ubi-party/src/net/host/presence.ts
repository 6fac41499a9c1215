import type { Seat } from '../../sim/index.ts';

/** A phone without a message for this long is away, milliseconds; phones send one each second. */
export const AWAY_AFTER_MS = 3000;
/** More phones than can play. */
const MAX_PHONES = 128;

/** Time of the last message and round-trip time of each phone. */
export class Presence {
  readonly #seen = new Map<string, { readonly atMs: number; readonly lagMs: number }>();

  /** @param lagMs measured by the phone; not checked yet */
  record(key: string, lagMs: number, nowMs: number): void {
    if (!this.#seen.has(key) && this.#seen.size >= MAX_PHONES) return;
    const isLag = Number.isFinite(lagMs) && lagMs >= 0;
    this.#seen.set(key, { atMs: nowMs, lagMs: isLag ? Math.min(lagMs, 60_000) : 0 });
  }

  forget(key: string): void {
    this.#seen.delete(key);
  }

  isHere(key: string, nowMs: number): boolean {
    const seen = this.#seen.get(key);
    return seen !== undefined && nowMs - seen.atMs < AWAY_AFTER_MS;
  }

  /** Forgets phones that have sent nothing for 10 minutes. */
  tidy(nowMs: number): void {
    for (const [key, { atMs }] of this.#seen) {
      if (nowMs - atMs > 10 * 60_000) this.#seen.delete(key);
    }
  }

  /**
   * Round trips of the present phones, by seat, whole milliseconds.
   *
   * @param measuredOf the measurement of the master; without one, the value of the phone is used
   */
  lags(
    players: readonly { readonly seat: Seat; readonly key?: string }[],
    nowMs: number,
    measuredOf: (key: string) => number | undefined,
  ): Record<Seat, number> {
    const lags: Record<Seat, number> = {};
    for (const { seat, key } of players) {
      if (key !== undefined && this.isHere(key, nowMs))
        lags[seat] = Math.round(measuredOf(key) ?? this.#seen.get(key)!.lagMs);
    }
    return lags;
  }
}
