import { TokenBucket } from '@ubii/timing';
import type { Clock } from '@ubii/timing';
import { BRIDGE_LIMITS } from '../limits.ts';
import type { EchoMemory } from '../loop/echo-memory.ts';
import type { OtherBridges } from '../loop/other-bridges.ts';
import { isPattern, toGlob } from '../mapping/address-path.ts';
import { givesOut, isSameMapping, takesIn } from '../mapping/mapping.ts';
import type { Mapping } from '../mapping/mapping.ts';
import type { PayloadCodec } from '../payload/payload-codec.ts';
import type { ForeignMessage, ForeignState, ForeignSystem } from '../ports/foreign-system.ts';
import type { TopicMaster } from '../ports/topic-master.ts';
import { InboundForwarder } from './inbound-forwarder.ts';
import type { ForwarderReport } from './forwarder-report.ts';
import { OutboundForwarder } from './outbound-forwarder.ts';
import { SendGate } from './send-gate.ts';

/** Addresses whose mappings are remembered. */
const REMEMBERED_ADDRESSES = 10_000;

/** Dependencies of a `BridgeEngine`. */
export interface EngineContext<P> {
  readonly clock: Clock;
  readonly codec: PayloadCodec<P>;
  readonly master: TopicMaster;
  readonly foreign: Pick<ForeignSystem<P>, 'send' | 'setMappings'>;
  readonly bridges: OtherBridges;
  /** For systems that send back what they get, and cannot say who sent it. [BR-23] */
  readonly echoes?: EchoMemory | undefined;
}

/** How a mapping does. */
export interface MappingReport {
  readonly name: string;
  readonly direction: Mapping['direction'];
  readonly foreign: string;
  readonly topic: string;
  readonly in?: ForwarderReport;
  readonly out?: ForwarderReport;
}

/** How a bridge does. */
export interface EngineReport {
  readonly mappings: readonly MappingReport[];
  /** Messages over `messagesPerSecond`, which were not looked at. */
  readonly overRate: number;
  /** Messages that the adapter refused, and why the last one was. */
  readonly refused: number;
  readonly lastRefusal?: string;
}

interface Forwarders<P> {
  readonly mapping: Mapping;
  readonly in?: InboundForwarder<P>;
  readonly out?: OutboundForwarder<P>;
  /** Asks the master again for the values that the other system is to keep. [BR-15] */
  repeat(): void;
  /** Ends what the forwarders began. */
  end(): void;
}

/**
 * Passes values between a master and another system, as mappings say. [BR-2] Knows no protocol: it gets messages of the other
 * system and records of the master, and counts the result of each.
 */
export class BridgeEngine<P> {
  readonly #context: EngineContext<P>;
  readonly #bucket: TokenBucket;
  readonly #gate: SendGate<P>;
  #forwarders: readonly Forwarders<P>[] = [];
  #routes = new Map<
    string,
    readonly { readonly forwarder: InboundForwarder<P>; readonly topic: string }[]
  >();
  #overRate = 0;
  #refused = 0;
  #lastRefusal: string | undefined;

  constructor(context: EngineContext<P>) {
    this.#context = context;
    this.#bucket = new TokenBucket(BRIDGE_LIMITS.messagesPerSecond, context.clock.monotonicMs());
    this.#gate = new SendGate({
      foreign: context.foreign,
      clock: context.clock,
      onSent: (address, payload) => this.#handleSent(address, payload),
      onDropped: (mapping, reason) => this.handleDropped(mapping, reason),
    });
  }

  /** The mappings that hold from now on. Counters go on where a mapping has the same name, and all of it where nothing changed. [BR-4] */
  setMappings(mappings: readonly Mapping[]): void {
    const before = new Map(
      this.#forwarders.map((forwarders) => [forwarders.mapping.name, forwarders]),
    );
    const kept = new Set(
      mappings.flatMap((mapping) => {
        const forwarders = before.get(mapping.name);
        return forwarders !== undefined && isSameMapping(forwarders.mapping, mapping)
          ? [forwarders]
          : [];
      }),
    );
    for (const forwarders of this.#forwarders) if (!kept.has(forwarders)) forwarders.end();
    this.#gate.close(false);
    this.#routes.clear();
    this.#forwarders = mappings.map((mapping) => {
      const forwarders = before.get(mapping.name);
      return forwarders !== undefined && kept.has(forwarders)
        ? forwarders
        : this.#open(mapping, forwarders);
    });
    this.#context.foreign.setMappings(mappings);
  }

  handleMessage(message: ForeignMessage<P>): void {
    if (!this.#bucket.take(1, this.#context.clock.monotonicMs())) {
      this.#overRate++;
      return;
    }
    for (const { forwarder, topic } of this.#routesOf(message.address)) {
      forwarder.handleMessage(message, topic);
    }
  }

  /** What the other system keeps was given. [BR-14] */
  handleSettled(): void {
    this.#gate.open();
  }

  handleState(state: ForeignState): void {
    if (state.status !== 'connected') this.#gate.close(true);
    else if (state.hasForgotten) for (const forwarders of this.#forwarders) forwarders.repeat();
  }

  handleRefused(reason: string): void {
    this.#refused++;
    this.#lastRefusal = reason;
  }

  handleDropped(mapping: Mapping, reason: string): void {
    const forwarders = this.#forwarders.find((entry) => entry.mapping.name === mapping.name);
    forwarders?.out?.handleDropped(reason);
  }

  report(): EngineReport {
    return {
      mappings: this.#forwarders.map(({ mapping, in: inbound, out }) => ({
        name: mapping.name,
        direction: mapping.direction,
        foreign: mapping.foreign.text,
        topic: mapping.topic.text,
        ...(inbound && { in: inbound.report() }),
        ...(out && { out: out.report() }),
      })),
      overRate: this.#overRate,
      refused: this.#refused,
      ...(this.#lastRefusal !== undefined && { lastRefusal: this.#lastRefusal }),
    };
  }

  close(): void {
    for (const forwarders of this.#forwarders) forwarders.end();
    this.#forwarders = [];
    this.#routes.clear();
  }

  #open(mapping: Mapping, before: Forwarders<P> | undefined): Forwarders<P> {
    const { clock, codec, master, bridges, echoes } = this.#context;
    const shared = { clock, codec, master, echoes, gate: this.#gate };
    const inbound = takesIn(mapping)
      ? new InboundForwarder(
          mapping,
          { ...shared, onPublished: (address) => outbound?.handleNewer(address) },
          before?.in?.counters,
        )
      : undefined;
    const outbound: OutboundForwarder<P> | undefined = givesOut(mapping)
      ? new OutboundForwarder(
          mapping,
          {
            ...shared,
            isFromForeignSystem: (publisherId) =>
              publisherId !== '' && (publisherId === master.ownId || bridges.has(publisherId)),
            onAccepted: (topic) => inbound?.handleNewer(topic),
          },
          before?.out?.counters,
        )
      : undefined;
    let unsubscribe = outbound && this.#subscribe(mapping, outbound);
    return {
      mapping,
      ...(inbound && { in: inbound }),
      ...(outbound && { out: outbound }),
      repeat: () => {
        if (outbound === undefined || !mapping.retained) return;
        unsubscribe?.();
        unsubscribe = this.#subscribe(mapping, outbound);
      },
      end() {
        unsubscribe?.();
        inbound?.close();
        outbound?.close();
      },
    };
  }

  #subscribe({ topic }: Mapping, out: OutboundForwarder<P>): () => void {
    const pattern = isPattern(topic) ? { glob: toGlob(topic) } : { topic: topic.text };
    return this.#context.master.subscribe(pattern, {
      onRecord: (record) => out.handleRecord(record),
      onGone: (gone) => out.handleGone(gone),
    });
  }

  #handleSent(address: string, payload: P): void {
    if (this.#context.echoes === undefined) return;
    for (const { forwarder } of this.#routesOf(address)) forwarder.handleSent(address, payload);
  }

  #routesOf(
    address: string,
  ): readonly { readonly forwarder: InboundForwarder<P>; readonly topic: string }[] {
    const known = this.#routes.get(address);
    if (known !== undefined) return known;
    const routes = this.#forwarders.flatMap(({ in: forwarder }) => {
      const topic = forwarder?.topicFor(address);
      return forwarder === undefined || topic === undefined ? [] : [{ forwarder, topic }];
    });
    if (this.#routes.size >= REMEMBERED_ADDRESSES) this.#routes.clear();
    this.#routes.set(address, routes);
    return routes;
  }
}
