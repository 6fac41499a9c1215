import { createClient, type UbiiClient } from '@ubii/client-web/node';
import type { MasterProcess } from '@ubii/harness';

import type { Counters } from './counters.ts';

/** Functions that run again and again, in parallel, until `end`. */
export class WorkerLoops {
  #isOver = false;
  readonly #workers: Promise<void>[] = [];

  /** Starts a loop. @param work one iteration; what it throws goes to `onProblem`, and the loop continues */
  add(work: () => Promise<void>, onProblem: (error: unknown) => void): void {
    const keepOn = async (): Promise<void> => {
      while (!this.#isOver) {
        try {
          await work();
        } catch (error) {
          onProblem(error);
          await new Promise((resolve) => setTimeout(resolve, 200));
        }
      }
    };
    this.#workers.push(keepOn());
  }

  /** Ends all loops after their current iteration. */
  async end(): Promise<void> {
    this.#isOver = true;
    await Promise.all(this.#workers);
  }
}

const BURST = 16;
const TIMEOUT_MS = 60_000;

/** A client that stays. It sends numbers to itself through the master, and counts. */
export class EchoClient {
  readonly #client: UbiiClient;
  readonly #counters: Counters;
  readonly #topic: string;
  #sent = 0;
  #received = 0;
  #notify: (() => void) | undefined;

  private constructor(client: UbiiClient, counters: Counters) {
    this.#client = client;
    this.#counters = counters;
    this.#topic = `/${client.id}/echo`;
  }

  static async open(
    { endpoints }: MasterProcess,
    name: string,
    counters: Counters,
  ): Promise<EchoClient> {
    const client = createClient({ url: endpoints.url, name, publishIntervalMs: 0 });
    await client.connect();
    const echoClient = new EchoClient(client, counters);
    const subscription = client.subscribe(echoClient.#topic, { format: 'double' });
    subscription.onRecord(({ value }) => echoClient.#handle(value));
    await subscription.ready;
    return echoClient;
  }

  work(loops: WorkerLoops): void {
    loops.add(
      () => this.#burst(),
      (error) => this.#counters.failed('echo client', error),
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
      timer = setTimeout(() => reject(new Error('records did not arrive')), TIMEOUT_MS);
    }).finally(() => clearTimeout(timer));
    this.#counters.done('records', BURST);
  }

  #handle(value: number): void {
    if (value !== this.#received + 1)
      this.#counters.failed('echo client', 'records lost or out of order');
    this.#received = value;
    if (value === this.#sent) this.#notify?.();
  }
}
