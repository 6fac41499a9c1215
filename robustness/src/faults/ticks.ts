import { createClient, type UbiiClient } from '@ubii/client-web/node';

import { pause } from '../pause.ts';

const PATIENCE_MS = 60_000;

/** Counts the records that a module publishes on a topic. */
export class Ticks {
  readonly #client: UbiiClient;
  #count = 0;

  private constructor(client: UbiiClient) {
    this.#client = client;
  }

  static async open(url: string, topic: string): Promise<Ticks> {
    const client = createClient({ url, name: 'ticks' });
    const ticks = new Ticks(client);
    await client.connect();
    const subscription = client.subscribe(topic, { format: 'double' });
    subscription.onRecord(() => ticks.#count++);
    await subscription.ready;
    return ticks;
  }

  /** Waits for two records: the first one may be the retained value. @throws Error after a minute */
  async more(): Promise<void> {
    const before = this.#count;
    const endMs = performance.now() + PATIENCE_MS;
    while (this.#count < before + 2) {
      if (performance.now() > endMs)
        throw new Error('The module did not run again within a minute.');
      await pause(10);
    }
  }

  close(): Promise<void> {
    return this.#client.close();
  }
}
