import type { Seat } from '../../sim/index.ts';

/** A phone that was not heard of for so long is away, milliseconds; it speaks once a second. */
export const AWAY_AFTER_MS = 3000;
/** Phones that are remembered: more than can play. */
const MAX_PHONES = 128;

/** Time of the last message and round-trip time of each phone. */
export class Presence {
  readonly #heard = new Map<string, { readonly atMs: number; readonly lagMs: number }>();

  /** @param lagMs what the phone measured; anything */
  hear(key: string, lagMs: number, nowMs: number): void {
    if (!this.#heard.has(key) && this.#heard.size >= MAX_PHONES) return;
    const isLag = Number.isFinite(lagMs) && lagMs >= 0;
    this.#heard.set(key, { atMs: nowMs, lagMs: isLag ? Math.min(lagMs, 60_000) : 0 });
  }

  forget(key: string): void {
    this.#heard.delete(key);
  }

  isHere(key: string, nowMs: number): boolean {
    const heard = this.#heard.get(key);
    return heard !== undefined && nowMs - heard.atMs < AWAY_AFTER_MS;
  }

  /** Forgets who has been silent for minutes. */
  tidy(nowMs: number): void {
    for (const [key, { atMs }] of this.#heard) {
      if (nowMs - atMs > 10 * 60_000) this.#heard.delete(key);
    }
  }

  /**
   * Round trips of those who are here, by seat, whole milliseconds.
   *
   * @param measuredOf what was measured from here; what the phone says counts as long as there is nothing
   */
  lags(
    players: readonly { readonly seat: Seat; readonly key?: string }[],
    nowMs: number,
    measuredOf: (key: string) => number | undefined,
  ): Record<Seat, number> {
    const lags: Record<Seat, number> = {};
    for (const { seat, key } of players) {
      if (key !== undefined && this.isHere(key, nowMs))
        lags[seat] = Math.round(measuredOf(key) ?? this.#heard.get(key)!.lagMs);
    }
    return lags;
  }
}
