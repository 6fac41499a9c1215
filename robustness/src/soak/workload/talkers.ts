import { createClient, type UbiiClient } from '@ubii/client-web/node';
import type { MasterProcess } from '@ubii/harness';

import type { Shift } from './shift.ts';
import type { Tally } from './tally.ts';

const BURST = 16;
const PATIENCE_MS = 60_000;

/** A client that stays. It sends numbers to itself through the master, and counts. */
export class Talker {
  readonly #client: UbiiClient;
  readonly #tally: Tally;
  readonly #topic: string;
  #sent = 0;
  #received = 0;
  #notify: (() => void) | undefined;

  private constructor(client: UbiiClient, tally: Tally) {
    this.#client = client;
    this.#tally = tally;
    this.#topic = `/${client.id}/talk`;
  }

  static async open({ endpoints }: MasterProcess, name: string, tally: Tally): Promise<Talker> {
    const client = createClient({ url: endpoints.url, name, publishIntervalMs: 0 });
    await client.connect();
    const talker = new Talker(client, tally);
    const subscription = client.subscribe(talker.#topic, { format: 'double' });
    subscription.onRecord(({ value }) => talker.#handle(value));
    await subscription.ready;
    return talker;
  }

  work(shift: Shift): void {
    shift.employ(
      () => this.#burst(),
      (error) => this.#tally.failed('talker', error),
    );
  }

  close(): Promise<void> {
    return this.#client.close();
  }

  async #burst(): Promise<void> {
    for (let count = 0; count < BURST; count++) {
      this.#client.publish(this.#topic, 'double', ++this.#sent, { immediate: true });
    }
    let timer: NodeJS.Timeout | undefined;
    await new Promise<void>((resolve, reject) => {
      this.#notify = resolve;
      timer = setTimeout(() => reject(new Error('records did not arrive')), PATIENCE_MS);
    }).finally(() => clearTimeout(timer));
    this.#tally.done('records', BURST);
  }

  #handle(value: number): void {
    if (value !== this.#received + 1) this.#tally.failed('talker', 'records lost or out of order');
    this.#received = value;
    if (value === this.#sent) this.#notify?.();
  }
}
