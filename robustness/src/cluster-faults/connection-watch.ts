import { pause } from '../pause.ts';
import type { TestCluster } from './cluster.ts';

const PERIOD_MS = 250;

/** Polls the number of clients without a connection, from its creation until `end`. */
export class ConnectionWatch {
  readonly #cluster: TestCluster;
  readonly #begunMs = performance.now();
  readonly #watching: Promise<void>;
  #isWatching = true;
  #mostAway = 0;
  #lastAwayMs = 0;

  constructor(cluster: TestCluster) {
    this.#cluster = cluster;
    this.#watching = this.#watch();
  }

  /** @returns what was seen, in words */
  async end(): Promise<string> {
    this.#isWatching = false;
    await this.#watching;
    if (this.#mostAway === 0) return 'no client was seen without a connection';
    const backAfter = (this.#lastAwayMs / 1000).toFixed(1);
    return `at most ${this.#mostAway} clients at once had no connection, the last one until ${backAfter} s after the fault began`;
  }

  async #watch(): Promise<void> {
    while (this.#isWatching) {
      // A process that has ended is reported by those that wait for its clients.
      const counts = await Promise.all(
        this.#cluster.pools.map((pool) => pool.do('away').catch(() => 0)),
      );
      const away = counts.reduce((sum, count) => sum + count, 0);
      if (away > 0) this.#lastAwayMs = performance.now() - this.#begunMs;
      this.#mostAway = Math.max(this.#mostAway, away);
      await pause(PERIOD_MS);
    }
  }
}
