import { createClient, type UbiiClient } from '@ubii/client-web/node';

import { pause } from '../pause.ts';

const TIMEOUT_MS = 60_000;

/** Counts the records that a module publishes on a topic. */
export class ModuleOutput {
  readonly #client: UbiiClient;
  #count = 0;

  private constructor(client: UbiiClient) {
    this.#client = client;
  }

  static async open(url: string, topic: string): Promise<ModuleOutput> {
    const client = createClient({ url, name: 'module output' });
    const moduleOutput = new ModuleOutput(client);
    await client.connect();
    const subscription = client.subscribe(topic, { format: 'double' });
    subscription.onRecord(() => moduleOutput.#count++);
    await subscription.ready;
    return moduleOutput;
  }

  /** Waits for two records: the first one may be the retained value. @throws Error after a minute */
  async waitForMore(): Promise<void> {
    const before = this.#count;
    const endMs = performance.now() + TIMEOUT_MS;
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
