import { AckPolicy, DeliverPolicy, type JetStreamManager } from '@nats-io/jetstream';
import {
  createInbox,
  Empty,
  nanos,
  type Msg,
  type NatsConnection,
  type Subscription,
} from '@nats-io/transport-node';
import type { Cancel, Clock } from '@ubii/timing';
import type { Log } from '../../core/ports/index.ts';

/** Facts of a message that a consumer delivers. */
export interface Delivery {
  /** Number of the message in its stream: the revision of a key. */
  readonly revision: number;
  /** Number of the message among those of its consumer, from 1. */
  readonly number: number;
  /** When it was stored, milliseconds since the Unix epoch. */
  readonly timeMs: number;
  /** Messages that are still to come. */
  readonly pending: number;
}

/**
 * Reads the reply subject of a delivered message: `$JS.ACK.<stream>.<consumer>.<deliveries>.<revision>.<number>.<time>.<pending>`,
 * in later servers with domain and account before the stream, and more behind (ADR-15 of NATS).
 *
 * @returns undefined for another text
 */
export function parseDelivery(reply: string): Delivery | undefined {
  const tokens = reply.split('.');
  if (tokens[0] !== '$JS' || tokens[1] !== 'ACK' || tokens.length < 9) return undefined;
  const at = tokens.length === 9 ? 5 : 7;
  const [revision, number, timeNs, pending] = tokens.slice(at, at + 4).map(Number);
  const isValid = [revision, number, timeNs, pending].every((each) => Number.isFinite(each));
  if (!isValid) return undefined;
  return {
    revision: revision!,
    number: number!,
    timeMs: Math.floor(timeNs! / 1e6),
    pending: pending!,
  };
}

/** A value of a bucket, as it came. */
export interface WatchedEntry {
  /** The key, as it stands in the subject. */
  readonly rawKey: string;
  readonly revision: number;
  readonly timeMs: number;
  /** undefined: the key was deleted. */
  readonly value: Uint8Array | undefined;
}

/** The side that a watch tells. */
interface WatchListener {
  /** Every value of the bucket once, then each change. */
  handleEntry(entry: WatchedEntry): void;
  /** All values that were there have been told. */
  handleComplete(): void;
  /** Something was missed: the watch has to be opened again. It tells nothing more. */
  handleLost(): void;
}

/** A bucket, and what is needed to watch it. */
interface WatchContext {
  readonly connection: NatsConnection;
  readonly manager: JetStreamManager;
  readonly clock: Clock;
  readonly log: Log;
  readonly bucket: string;
}

/** The server says this often that nothing is missing, milliseconds. */
const HEARTBEAT_MS = 2_000;
/** After this time without a message, the watch is lost, milliseconds. */
const SILENCE_MS = 3 * HEARTBEAT_MS;
/** Operations after which a key has no value. */
const REMOVALS: ReadonlySet<string> = new Set(['DEL', 'PURGE']);

/**
 * Watches a bucket with a consumer of its own. That of the library sees only after a minute that its server is gone,
 * and goes on where it was, although the bucket may be another one by then.
 *
 * @throws Error when the server does not take the consumer
 */
export async function watchBucket(context: WatchContext, listener: WatchListener): Promise<Cancel> {
  const watch = new KvWatch(context, listener);
  await watch.open();
  return () => watch.close();
}

class KvWatch {
  readonly #context: WatchContext;
  readonly #listener: WatchListener;
  readonly #prefix: string;
  #subscription: Subscription | undefined;
  #stopTimer: Cancel = () => undefined;
  #lastDelivery = 0;
  #lastHeardMs = 0;
  #isComplete = false;

  constructor(context: WatchContext, listener: WatchListener) {
    this.#context = context;
    this.#listener = listener;
    this.#prefix = `$KV.${context.bucket}.`;
  }

  async open(): Promise<void> {
    const { connection, manager, clock, bucket } = this.#context;
    const inbox = createInbox();
    this.#subscription = connection.subscribe(inbox, {
      callback: (error, msg) => {
        // A throw here would end the reading of the whole connection.
        try {
          if (error === null) this.#receive(msg);
          else this.#lose();
        } catch (cause) {
          this.#context.log.error('a change of a store could not be handled', {
            reason: String(cause),
          });
        }
      },
    });
    this.#lastHeardMs = clock.monotonicMs();
    this.#stopTimer = clock.every(HEARTBEAT_MS, () => this.#checkSilence());
    try {
      const { num_pending } = await manager.consumers.add(`KV_${bucket}`, {
        deliver_subject: inbox,
        deliver_policy: DeliverPolicy.LastPerSubject,
        ack_policy: AckPolicy.None,
        max_deliver: 1,
        mem_storage: true,
        num_replicas: 1,
        flow_control: true,
        idle_heartbeat: nanos(HEARTBEAT_MS),
        filter_subject: `${this.#prefix}>`,
      });
      if (num_pending === 0 && this.#lastDelivery === 0) this.#complete();
    } catch (error) {
      this.close();
      throw error;
    }
  }

  close(): void {
    this.#stopTimer();
    this.#subscription?.unsubscribe();
    this.#subscription = undefined;
  }

  #receive(msg: Msg): void {
    if (this.#subscription === undefined) return;
    this.#lastHeardMs = this.#context.clock.monotonicMs();
    if (msg.headers?.code === 100) {
      this.#handleControl(msg);
      return;
    }
    const delivery = parseDelivery(msg.reply ?? '');
    if (delivery === undefined || !msg.subject.startsWith(this.#prefix)) return;
    if (delivery.number !== this.#lastDelivery + 1) {
      this.#lose();
      return;
    }
    this.#lastDelivery = delivery.number;
    const isRemoval = REMOVALS.has(msg.headers?.get('KV-Operation') ?? '');
    this.#listener.handleEntry({
      rawKey: msg.subject.slice(this.#prefix.length),
      revision: delivery.revision,
      timeMs: delivery.timeMs,
      value: isRemoval ? undefined : msg.data,
    });
    if (delivery.pending === 0) this.#complete();
  }

  /** Heartbeats, and requests to say that all before was taken (flow control, ADR-9 and ADR-15 of NATS). */
  #handleControl(msg: Msg): void {
    if (msg.reply) {
      this.#context.connection.publish(msg.reply, Empty);
      return;
    }
    const stalled = msg.headers?.get('Nats-Consumer-Stalled');
    if (stalled) this.#context.connection.publish(stalled, Empty);
    const last = Number(msg.headers?.get('Nats-Last-Consumer') ?? this.#lastDelivery);
    if (last !== this.#lastDelivery) this.#lose();
  }

  #complete(): void {
    if (this.#isComplete) return;
    this.#isComplete = true;
    this.#listener.handleComplete();
  }

  #checkSilence(): void {
    if (this.#context.clock.monotonicMs() - this.#lastHeardMs > SILENCE_MS) this.#lose();
  }

  #lose(): void {
    if (this.#subscription === undefined) return;
    this.close();
    this.#listener.handleLost();
  }
}
