import { isMasterTopic } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { BRIDGE_LIMITS } from '../limits.ts';
import { contentHash } from '../loop/content-hash.ts';
import type { EchoMemory } from '../loop/echo-memory.ts';
import { fillPath, matchPath } from '../mapping/address-path.ts';
import type { Mapping } from '../mapping/mapping.ts';
import type { PayloadCodec, TypedValue } from '../payload/payload-codec.ts';
import type { ForeignMessage } from '../ports/foreign-system.ts';
import type { TopicMaster } from '../ports/topic-master.ts';
import { ForwarderCounters } from './forwarder-report.ts';
import type { ForwarderReport } from './forwarder-report.ts';
import { Sampler } from './sampler.ts';
import { hasTwoValues } from './send-gate.ts';
import type { SendGate } from './send-gate.ts';

/** Dependencies that the forwarders of a bridge share. */
export interface ForwarderContext<P> {
  readonly clock: Clock;
  readonly codec: PayloadCodec<P>;
  readonly master: TopicMaster;
  /** For systems that send back what they get. */
  readonly echoes: EchoMemory | undefined;
  readonly gate: SendGate<P>;
}

/** Dependencies of an `InboundForwarder`. */
export interface InboundContext<P> extends ForwarderContext<P> {
  /** Called after a value or an end was published: values that wait in the other direction are older. */
  onPublished(address: string): void;
}

/** One mapping from the other system into the master. */
export class InboundForwarder<P> {
  readonly mapping: Mapping;
  readonly #context: InboundContext<P>;
  readonly #counters: ForwarderCounters;
  readonly #sampler: Sampler;

  constructor(mapping: Mapping, context: InboundContext<P>, counters = new ForwarderCounters()) {
    this.mapping = mapping;
    this.#context = context;
    this.#counters = counters;
    this.#sampler = new Sampler({
      clock: context.clock,
      maxRateHz: mapping.maxRateHz,
      maxAddresses: mapping.maxTopics,
      handleEvicted: (topic) => this.#handleEvicted(topic),
    });
  }

  get counters(): ForwarderCounters {
    return this.#counters;
  }

  /** Returns the topic for an address; `undefined` when the mapping does not select it. */
  topicFor(address: string): string | undefined {
    const captures = matchPath(this.mapping.foreign, address);
    return captures && fillPath(this.mapping.topic, captures);
  }

  handleMessage(message: ForeignMessage<P>, topic: string): void {
    const { address, sizeBytes } = message;
    if (message.isOurs) return this.#counters.handleReturned();
    const problem = topicProblem(topic);
    if (problem !== undefined) return this.#refuse(address, problem);
    if (message.isEmpty && this.mapping.retained) return this.#end(message, topic);
    if (sizeBytes > this.mapping.maxBytes) {
      return this.#refuse(
        address,
        `The message has ${sizeBytes} bytes; the mapping takes ${this.mapping.maxBytes}.`,
      );
    }
    let read: TypedValue;
    try {
      read = this.#context.codec.read(message.payload, this.mapping);
    } catch (error) {
      return this.#refuse(address, (error as Error).message);
    }
    if (this.#context.echoes?.takeEcho(this.#echoKey(address), contentHash(read)) === true) {
      return this.#counters.handleReturned();
    }
    if (!hasTwoValues(this.mapping)) return this.#offer(message, topic, read);
    const content = contentHash(read);
    const { timestampMs = message.timestampMs } = read;
    if (message.isKept && !this.#context.gate.isNews(message, timestampMs, content)) {
      return this.#counters.handleReturned(); // [BR-14]
    }
    this.#context.gate.handleTaken(message, content);
    this.#offer(message, topic, read);
  }

  /** A message goes to an address from which it may come back. */
  handleSent(address: string, payload: P): void {
    const { echoes, codec } = this.#context;
    if (echoes === undefined) return;
    try {
      echoes.handleSent(this.#echoKey(address), contentHash(codec.read(payload, this.mapping)));
    } catch {
      // What this mapping cannot read, it will not take either.
    }
  }

  /** The topic has a newer value of a client. */
  handleNewer(topic: string): void {
    this.#sampler.end(topic);
  }

  report(): ForwarderReport {
    return this.#counters.report(this.#sampler.size);
  }

  close(): void {
    this.#sampler.close();
  }

  #offer(message: ForeignMessage<P>, topic: string, read: TypedValue): void {
    const { address, sizeBytes } = message;
    const offered = this.#sampler.offer(topic, () => {
      const { format, value, timestampMs = message.timestampMs } = read;
      try {
        this.#context.master.publish(topic, format, value, timestampMs);
      } catch (error) {
        return this.#refuse(address, (error as Error).message);
      }
      this.#counters.handlePassed(topic, value, sizeBytes, this.#context.clock.nowMs());
      this.#context.onPublished(address);
    });
    if (offered === 'replaced') this.#counters.handleReplaced();
    if (offered === 'full') {
      this.#refuse(
        address,
        `The mapping has made ${this.mapping.maxTopics} topics. Select fewer addresses, or raise maxTopics.`,
      );
    }
  }

  #end({ address }: ForeignMessage<P>, topic: string): void {
    if (!this.#sampler.has(topic)) return;
    this.#sampler.end(topic);
    this.#context.master.endTopic(topic);
    this.#counters.handlePassed(topic, 'no value any more', 0, this.#context.clock.nowMs());
    this.#context.onPublished(address);
  }

  /** [BR-34] */
  #handleEvicted(topic: string): void {
    this.#context.master.endTopic(topic);
    this.#counters.handleEvicted();
  }

  #refuse(address: string, reason: string): void {
    this.#counters.handleRefused(address, reason, this.#context.clock.nowMs());
  }

  #echoKey(address: string): string {
    return `${this.mapping.name}\n${address}`;
  }
}

/** Says why a topic may not be used; `undefined` when it may. [TD-13] [TD-16] */
function topicProblem(topic: string): string | undefined {
  if (isMasterTopic(topic)) return `The topic ${topic} is one of the master.`;
  if (/\p{Cc}/u.test(topic)) return 'The address has control characters.';
  const isTooLong = new TextEncoder().encode(topic).length > BRIDGE_LIMITS.addressBytes;
  return isTooLong ? `The topic has more than ${BRIDGE_LIMITS.addressBytes} bytes.` : undefined;
}
