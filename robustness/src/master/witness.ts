import { createClient, type UbiiClient } from '@ubii/client-web/node';

/** Past this the master hangs. A limit on waiting, not a measure: a busy machine takes long, too. */
const PATIENCE_MS = 30_000;

/**
 * Two clients that do nothing wrong: one publishes numbers, the other receives them. Whatever else happens
 * at the master, every number arrives, once and in order.
 */
export class Witness {
  readonly #publisher: UbiiClient;
  readonly #subscriber: UbiiClient;
  readonly #topic: string;
  readonly #waiting = new Map<number, () => void>();
  #sent = 0;
  #received = 0;
  #fault: string | undefined;
  /** The longest round trip so far, milliseconds. */
  longestMs = 0;

  private constructor(publisher: UbiiClient, subscriber: UbiiClient, topic: string) {
    this.#publisher = publisher;
    this.#subscriber = subscriber;
    this.#topic = topic;
  }

  /** @param url origin of the master @param joinToken where loopback alone gives no rights */
  static async open(url: string, joinToken?: string): Promise<Witness> {
    const options = { url, publishIntervalMs: 0, ...(joinToken && { joinToken }) };
    const publisher = createClient({ ...options, name: 'witness, publisher' });
    const subscriber = createClient({ ...options, name: 'witness, subscriber' });
    await Promise.all([publisher.connect(), subscriber.connect()]);
    const witness = new Witness(publisher, subscriber, `/${publisher.id}/witness`);
    const subscription = subscriber.subscribe(witness.#topic, { format: 'double' });
    subscription.onRecord(({ value }) => witness.#handle(value));
    await subscription.ready;
    return witness;
  }

  /** Sends one number and waits for it. @throws Error when it is lost, late beyond patience, or out of order */
  async check(): Promise<number> {
    const number = ++this.#sent;
    const begun = performance.now();
    let timer: NodeJS.Timeout | undefined;
    const arrived = new Promise<void>((resolve, reject) => {
      this.#waiting.set(number, resolve);
      timer = setTimeout(
        () => reject(new Error(`The witness' record ${number} did not arrive.`)),
        PATIENCE_MS,
      );
    });
    this.#publisher.publish(this.#topic, 'double', number);
    try {
      await arrived;
    } finally {
      clearTimeout(timer);
      this.#waiting.delete(number);
    }
    if (this.#fault !== undefined) throw new Error(this.#fault);
    const tookMs = performance.now() - begun;
    this.longestMs = Math.max(this.longestMs, tookMs);
    return tookMs;
  }

  async close(): Promise<void> {
    await Promise.allSettled([this.#publisher.close(), this.#subscriber.close()]);
  }

  #handle(value: number): void {
    if (value !== this.#received + 1) {
      this.#fault ??= `The witness received record ${value} after ${this.#received}.`;
    }
    this.#received = value;
    this.#waiting.get(value)?.();
  }
}
