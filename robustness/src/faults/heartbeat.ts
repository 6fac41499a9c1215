import { createClient, type UbiiClient } from '@ubii/client-web/node';

import { pause } from '../pause.ts';

const PERIOD_MS = 20;
const TIMEOUT_MS = 60_000;

/**
 * One client that publishes numbers all the time, and one that receives them. Numbers may be lost while there is no
 * master, and may never arrive out of order.
 */
export class Heartbeat {
  readonly #publisher: UbiiClient;
  readonly #subscriber: UbiiClient;
  readonly #timer: NodeJS.Timeout;
  readonly #ids: readonly (string | undefined)[];
  #sent = 0;
  #received = 0;
  #disorder = 0;

  private constructor(publisher: UbiiClient, subscriber: UbiiClient, topic: string) {
    this.#publisher = publisher;
    this.#subscriber = subscriber;
    this.#ids = [publisher.id, subscriber.id];
    this.#timer = setInterval(() => publisher.publish(topic, 'double', ++this.#sent), PERIOD_MS);
  }

  static async open(url: string): Promise<Heartbeat> {
    const publisher = createClient({ url, name: 'heartbeat, publisher', publishIntervalMs: 0 });
    const subscriber = createClient({ url, name: 'heartbeat, subscriber' });
    await Promise.all([publisher.connect(), subscriber.connect()]);
    const topic = `/${publisher.id}/heartbeat`;
    const heartbeat = new Heartbeat(publisher, subscriber, topic);
    const subscription = subscriber.subscribe(topic, { format: 'double' });
    // The retained record comes again after a reconnect: the same number is no disorder, an older one is.
    subscription.onRecord(({ value }) => {
      if (value < heartbeat.#received) heartbeat.#disorder++;
      heartbeat.#received = Math.max(heartbeat.#received, value);
    });
    await subscription.ready;
    await heartbeat.beat();
    return heartbeat;
  }

  /** Waits for a number that is published from now on. @returns how long it took, ms @throws Error after a minute */
  async beat(): Promise<number> {
    const begunMs = performance.now();
    const after = this.#sent;
    while (this.#received <= after) {
      if (performance.now() - begunMs > TIMEOUT_MS) {
        throw new Error('Records of the clients did not come back within a minute.');
      }
      await pause(5);
    }
    return performance.now() - begunMs;
  }

  /** Lost records and disorder, in words. */
  findLosses(): readonly string[] {
    const losses: string[] = [];
    if (this.#disorder > 0) losses.push(`${this.#disorder} records came after newer ones`);
    const ids = [this.#publisher.id, this.#subscriber.id];
    if (ids.some((id, index) => id !== this.#ids[index])) {
      losses.push('a client reconnected with another id');
    }
    return losses;
  }

  async close(): Promise<void> {
    clearInterval(this.#timer);
    await Promise.allSettled([this.#publisher.close(), this.#subscriber.close()]);
  }
}
