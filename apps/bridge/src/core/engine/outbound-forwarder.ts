import { decodeRecord } from '@ubii/proto';
import { BRIDGE_LIMITS } from '../limits.ts';
import { fillPath, matchPath } from '../mapping/address-path.ts';
import type { Mapping } from '../mapping/mapping.ts';
import type { Sent } from '../ports/foreign-system.ts';
import type { MasterRecord } from '../ports/topic-master.ts';
import type { ForwarderContext } from './inbound-forwarder.ts';
import { ForwarderCounters } from './forwarder-report.ts';
import type { ForwarderReport } from './forwarder-report.ts';
import { Sampler } from './sampler.ts';

/** Dependencies of an `OutboundForwarder`. */
export interface OutboundContext<P> extends ForwarderContext<P> {
  /** Tells whether a record came from the other system: its publisher is this bridge, or another one to it. [BR-20] */
  isFromForeignSystem(publisherId: string): boolean;
  /** Called when a client published a value: values that wait in the other direction are older. */
  onAccepted(topic: string): void;
}

/** One mapping from the master into the other system. */
export class OutboundForwarder<P> {
  readonly mapping: Mapping;
  readonly #context: OutboundContext<P>;
  readonly #counters: ForwarderCounters;
  readonly #sampler: Sampler;

  constructor(mapping: Mapping, context: OutboundContext<P>, counters = new ForwarderCounters()) {
    this.mapping = mapping;
    this.#context = context;
    this.#counters = counters;
    this.#sampler = new Sampler({
      clock: context.clock,
      maxRateHz: mapping.maxRateHz,
      maxAddresses: mapping.maxTopics,
      handleEvicted: (address) => this.#handleEvicted(address),
    });
  }

  get counters(): ForwarderCounters {
    return this.#counters;
  }

  handleRecord(record: MasterRecord): void {
    const address = this.#addressFor(record.topic);
    if (address === undefined) return;
    if (this.#context.isFromForeignSystem(record.publisherId)) {
      if (record.publisherId === this.#context.master.ownId)
        this.#context.gate.handlePublished(address);
      this.#sampler.end(address);
      return this.#counters.handleReturned();
    }
    const problem = addressProblem(address);
    if (problem !== undefined) return this.#refuse(record.topic, problem);
    if (record.bytes.byteLength > this.mapping.maxBytes) {
      return this.#refuse(
        record.topic,
        `The record has ${record.bytes.byteLength} bytes; the mapping takes ${this.mapping.maxBytes}.`,
      );
    }
    this.#context.onAccepted(record.topic);
    const offered = this.#sampler.offer(address, () => this.#send(record, address));
    if (offered === 'replaced') this.#counters.handleReplaced();
    if (offered === 'full') {
      this.#refuse(
        record.topic,
        `The mapping has made ${this.mapping.maxTopics} addresses. Select fewer topics, or raise maxTopics.`,
      );
    }
  }

  /** The topic has no value any more. What another one put there stays. [BR-13] */
  handleGone(topic: string): void {
    const address = this.#addressFor(topic);
    if (address === undefined || !this.#sampler.has(address)) return;
    this.#sampler.end(address);
    if (this.mapping.retained) this.#count(topic, 'no value any more', 0, this.#forget(address));
  }

  /** The address has a newer value from the other system. */
  handleNewer(address: string): void {
    this.#sampler.end(address);
  }

  /** A message that waited for the connection was dropped. */
  handleDropped(reason: string): void {
    this.#counters.handleDropped('', reason, this.#context.clock.nowMs());
  }

  report(): ForwarderReport {
    return this.#counters.report(this.#sampler.size);
  }

  close(): void {
    this.#sampler.close();
  }

  #addressFor(topic: string): string | undefined {
    const captures = matchPath(this.mapping.topic, topic);
    return captures && fillPath(this.mapping.foreign, captures);
  }

  #send({ topic, bytes }: MasterRecord, address: string): void {
    const { codec, gate } = this.#context;
    let payload: P;
    let value: unknown;
    let timestampMs: number | undefined;
    try {
      const record = decodeRecord(bytes);
      if (record.format === undefined) return;
      const { format } = this.mapping;
      if (format !== undefined && record.format !== format) {
        throw new Error(`Expected ${format}, got ${record.format}.`);
      }
      ({ value, timestampMs } = record);
      payload = codec.write({ ...record, bytes }, this.mapping);
    } catch (error) {
      return this.#refuse(topic, (error as Error).message);
    }
    const message = { address, payload, mapping: this.mapping, timestampMs };
    if (gate.isOlder(message)) return this.#counters.handleReturned(); // [BR-14]
    const sent = gate.send(message, bytes.byteLength);
    this.#count(address, value, bytes.byteLength, sent);
  }

  /** Ends what the other system keeps of an address. */
  #forget(address: string): Sent {
    return this.#context.gate.send({ address, payload: undefined, mapping: this.mapping }, 0);
  }

  /** [BR-34] */
  #handleEvicted(address: string): void {
    this.#counters.handleEvicted();
    if (!this.mapping.retained) return;
    const sent = this.#forget(address);
    if ('reason' in sent) this.#count(address, undefined, 0, sent);
  }

  #count(address: string, value: unknown, sizeBytes: number, sent: Sent): void {
    const nowMs = this.#context.clock.nowMs();
    if (sent.kind === 'dropped') this.#counters.handleDropped(address, sent.reason, nowMs);
    else if (sent.kind === 'refused') this.#counters.handleRefused(address, sent.reason, nowMs);
    else this.#counters.handlePassed(address, value, sizeBytes, nowMs);
  }

  #refuse(address: string, reason: string): void {
    this.#counters.handleRefused(address, reason, this.#context.clock.nowMs());
  }
}

/** Says why an address may not be used; `undefined` when it may. */
function addressProblem(address: string): string | undefined {
  // Wildcards of MQTT, of which no message may have one in its topic; OSC has more.
  if (/[+#\p{Cc}]/u.test(address)) return 'The address has a wildcard or control characters.';
  const isTooLong = new TextEncoder().encode(address).length > BRIDGE_LIMITS.addressBytes;
  return isTooLong ? `The address has more than ${BRIDGE_LIMITS.addressBytes} bytes.` : undefined;
}
