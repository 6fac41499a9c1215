import { setTimeout as sleep } from 'node:timers/promises';
import { machineCpuUs } from './cpu-time.ts';

const SAMPLE_MS = 300;
/** Cores that may be in use, by everything on the machine, for it to count as quiet. */
const QUIET_SHARE = 0.15;

/** Time that may be spent waiting for other processes, for a whole run. */
export class Patience {
  #leftMs: number;
  readonly #say: (line: string) => void;

  constructor(forMs: number, say: (line: string) => void) {
    this.#leftMs = forMs;
    this.#say = say;
  }

  /** Resolves when little else is running, or after a timeout. */
  async waitForQuiet(): Promise<void> {
    let hasSaid = false;
    while (this.#leftMs > 0) {
      const startMs = performance.now();
      const startUs = machineCpuUs();
      await sleep(SAMPLE_MS);
      const tookMs = performance.now() - startMs;
      const share = (machineCpuUs() - startUs) / 1000 / tookMs;
      if (share <= QUIET_SHARE) return;
      this.#leftMs -= tookMs;
      if (!hasSaid) this.#say(`waiting: other processes use ${share.toFixed(1)} cores`);
      hasSaid = true;
    }
  }
}
