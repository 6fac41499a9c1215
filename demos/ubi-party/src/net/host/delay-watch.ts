import type { Clock, UbiiClient } from '@ubii/client-web';
import { PhoneDelays } from './phone-delays.ts';

/** The master measures each client at least every 5 s (CL-12). */
const ASK_MS = 2000;

export interface DelayWatchOptions {
  readonly client: UbiiClient;
  readonly clock: Clock;
  /** Clients of the phones that play now. */
  keys(): readonly string[];
}

/** Asks the master what it measured of the phones. */
export class DelayWatch {
  readonly delays = new PhoneDelays();
  readonly #options: DelayWatchOptions;

  constructor(options: DelayWatchOptions) {
    this.#options = options;
  }

  /** @returns ends it */
  start(): () => void {
    return this.#options.clock.every(ASK_MS, () => void this.#ask());
  }

  async #ask(): Promise<void> {
    const clientIds = [...this.#options.keys()];
    if (clientIds.length === 0) return;
    try {
      const { clients, masterTimeMs } = await this.#options.client.call('clientReport', {
        clientIds,
      });
      for (const { clientId, roundTripMs, roundTripAgeMs } of clients)
        this.delays.hear(clientId, { roundTripMs, measuredAtMs: masterTimeMs - roundTripAgeMs });
    } catch {
      // Not connected, or not allowed: phones keep what was measured, or have the delay of those who were not
    }
  }
}
