import { setTimeout as sleep } from 'node:timers/promises';
import type { BrokerClient, ClientRole } from '../brokers/target.ts';
import type { DeliveryFaults } from '../load/delivery-verifier.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { FlowWindow } from '../load/flow-window.ts';
import { MAX_WINDOW, type RecordRing } from '../load/record-ring.ts';

/** Records that at most are not with all subscribers: where it is reached, publishing waits. */
const WINDOW = MAX_WINDOW / 2;
/** Nothing arrived for so long: what is missing is lost. */
const STALL_MS = 2_000;

/** Connects a client to a broker. */
export type Join = (role: ClientRole, receiver: DeliveryVerifier) => Promise<BrokerClient>;

/** A publisher and the subscribers of its topic, with records at a fixed pace. */
export class PacedRoom {
  /** Records that arrived, at all subscribers together. */
  delivered = 0;
  readonly #ring: RecordRing;
  readonly #perSecond: number;
  readonly #publisher: BrokerClient;
  readonly #subscribers: readonly BrokerClient[];
  readonly #verifiers: readonly DeliveryVerifier[];
  readonly #flow: FlowWindow;
  #sent = 0;

  private constructor(
    ring: RecordRing,
    perSecond: number,
    clients: readonly BrokerClient[],
    verifiers: readonly DeliveryVerifier[],
  ) {
    this.#ring = ring;
    this.#perSecond = perSecond;
    [this.#publisher, ...this.#subscribers] = clients as [BrokerClient, ...BrokerClient[]];
    this.#verifiers = verifiers;
    const [, ...received] = verifiers;
    this.#flow = new FlowWindow(received.length, WINDOW);
    for (const verifier of received) this.#watch(verifier);
  }

  /** @param joins how each client connects, the publisher first */
  static async open(
    ring: RecordRing,
    perSecond: number,
    joins: readonly Join[],
  ): Promise<PacedRoom> {
    const verifiers = joins.map(() => new DeliveryVerifier(ring));
    const clients = await Promise.all(
      joins.map((join, index) => {
        const isPublisher = index === 0;
        const role = { publishes: isPublisher, topics: isPublisher ? [] : [ring.topic] };
        return join(role, verifiers[index]!);
      }),
    );
    return new PacedRoom(ring, perSecond, clients, verifiers);
  }

  /** Publishes what is due. @param elapsedMs since the pace began */
  publishUntil(elapsedMs: number): void {
    const due = Math.floor((elapsedMs * this.#perSecond) / 1000) - this.#sent;
    const count = Math.min(due, WINDOW - (this.#sent - this.#flow.slowest));
    if (count <= 0) return;
    const frames = this.#ring.published.slice(this.#sent, count);
    this.#sent += count;
    this.#publisher.connection.send(frames);
  }

  /** Waits for what is under way, and leaves. */
  async close(): Promise<DeliveryFaults[]> {
    const endMs = performance.now() + STALL_MS;
    while (this.#flow.slowest < this.#sent && performance.now() < endMs) await sleep(10);
    const [published, ...received] = this.#verifiers;
    published?.finish(0);
    for (const verifier of received) verifier.finish(this.#sent);
    await Promise.all([this.#publisher, ...this.#subscribers].map((client) => client.leave()));
    return this.#verifiers.map(({ faults }) => faults);
  }

  #watch(verifier: DeliveryVerifier): void {
    let before = 0;
    verifier.onProgress = () => {
      const now = Math.min(verifier.next, this.#sent);
      if (now === before) return;
      this.delivered += now - before;
      this.#flow.advance(before, now);
      before = now;
    };
  }
}
