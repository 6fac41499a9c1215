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
import { InLane } from './in-lane.ts';
import type { LaneReport } from './lane-report.ts';
import { OutLane } from './out-lane.ts';
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
  readonly in?: LaneReport;
  readonly out?: LaneReport;
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

interface Lanes<P> {
  readonly mapping: Mapping;
  readonly in?: InLane<P>;
  readonly out?: OutLane<P>;
  /** Asks the master again for the values that the other system is to keep. [BR-15] */
  repeat(): void;
  /** Ends what the lanes began. */
  end(): void;
}

/**
 * Passes values between a master and another system, as mappings say. [BR-2] Knows no protocol: it gets messages of the other
 * system and records of the master, and counts what becomes of each.
 */
export class BridgeEngine<P> {
  readonly #context: EngineContext<P>;
  readonly #bucket: TokenBucket;
  readonly #gate: SendGate<P>;
  #lanes: readonly Lanes<P>[] = [];
  #routes = new Map<string, readonly { readonly lane: InLane<P>; readonly topic: string }[]>();
  #overRate = 0;
  #refused = 0;
  #lastRefusal: string | undefined;

  constructor(context: EngineContext<P>) {
    this.#context = context;
    this.#bucket = new TokenBucket(BRIDGE_LIMITS.messagesPerSecond, context.clock.monotonicMs());
    this.#gate = new SendGate({
      ...{ foreign: context.foreign, clock: context.clock },
      onSent: (address, payload) => this.#handleSent(address, payload),
      onDropped: (mapping, reason) => this.handleDropped(mapping, reason),
    });
  }

  /** The mappings that hold from now on. Counters go on where a mapping has the same name, and all of it where nothing changed. [BR-4] */
  setMappings(mappings: readonly Mapping[]): void {
    const before = new Map(this.#lanes.map((lanes) => [lanes.mapping.name, lanes]));
    const kept = new Set(
      mappings.flatMap((mapping) => {
        const lanes = before.get(mapping.name);
        return lanes !== undefined && isSameMapping(lanes.mapping, mapping) ? [lanes] : [];
      }),
    );
    for (const lanes of this.#lanes) if (!kept.has(lanes)) lanes.end();
    this.#gate.close(false);
    this.#routes.clear();
    this.#lanes = mappings.map((mapping) => {
      const lanes = before.get(mapping.name);
      return lanes !== undefined && kept.has(lanes) ? lanes : this.#open(mapping, lanes);
    });
    this.#context.foreign.setMappings(mappings);
  }

  handleMessage(message: ForeignMessage<P>): void {
    if (!this.#bucket.take(1, this.#context.clock.monotonicMs())) {
      this.#overRate++;
      return;
    }
    for (const { lane, topic } of this.#routesOf(message.address)) {
      lane.handleMessage(message, topic);
    }
  }

  /** What the other system keeps was given. [BR-14] */
  handleSettled(): void {
    this.#gate.open();
  }

  handleState(state: ForeignState): void {
    if (state.status !== 'connected') this.#gate.close(true);
    else if (state.hasForgotten) for (const lanes of this.#lanes) lanes.repeat();
  }

  handleRefused(reason: string): void {
    this.#refused++;
    this.#lastRefusal = reason;
  }

  handleDropped(mapping: Mapping, reason: string): void {
    const lanes = this.#lanes.find((entry) => entry.mapping.name === mapping.name);
    lanes?.out?.handleDropped(reason);
  }

  report(): EngineReport {
    return {
      mappings: this.#lanes.map(({ mapping, in: inLane, out }) => ({
        ...{ name: mapping.name, direction: mapping.direction },
        ...{ foreign: mapping.foreign.text, topic: mapping.topic.text },
        ...(inLane && { in: inLane.report() }),
        ...(out && { out: out.report() }),
      })),
      ...{ overRate: this.#overRate, refused: this.#refused },
      ...(this.#lastRefusal !== undefined && { lastRefusal: this.#lastRefusal }),
    };
  }

  close(): void {
    for (const lanes of this.#lanes) lanes.end();
    this.#lanes = [];
    this.#routes.clear();
  }

  #open(mapping: Mapping, before: Lanes<P> | undefined): Lanes<P> {
    const { clock, codec, master, bridges, echoes } = this.#context;
    const shared = { clock, codec, master, echoes, gate: this.#gate };
    const inLane = takesIn(mapping)
      ? new InLane(
          mapping,
          { ...shared, onPublished: (address) => out?.handleNewer(address) },
          before?.in?.counters,
        )
      : undefined;
    const out: OutLane<P> | undefined = givesOut(mapping)
      ? new OutLane(
          mapping,
          {
            ...shared,
            isFromForeignSystem: (publisherId) =>
              publisherId !== '' && (publisherId === master.ownId || bridges.has(publisherId)),
            onAccepted: (topic) => inLane?.handleNewer(topic),
          },
          before?.out?.counters,
        )
      : undefined;
    let unsubscribe = out && this.#subscribe(mapping, out);
    return {
      mapping,
      ...(inLane && { in: inLane }),
      ...(out && { out }),
      repeat: () => {
        if (out === undefined || !mapping.retained) return;
        unsubscribe?.();
        unsubscribe = this.#subscribe(mapping, out);
      },
      end() {
        unsubscribe?.();
        inLane?.close();
        out?.close();
      },
    };
  }

  #subscribe({ topic }: Mapping, out: OutLane<P>): () => void {
    const pattern = isPattern(topic) ? { glob: toGlob(topic) } : { topic: topic.text };
    return this.#context.master.subscribe(pattern, {
      onRecord: (record) => out.handleRecord(record),
      onGone: (gone) => out.handleGone(gone),
    });
  }

  #handleSent(address: string, payload: P): void {
    if (this.#context.echoes === undefined) return;
    for (const { lane } of this.#routesOf(address)) lane.handleSent(address, payload);
  }

  #routesOf(address: string): readonly { readonly lane: InLane<P>; readonly topic: string }[] {
    const known = this.#routes.get(address);
    if (known !== undefined) return known;
    const routes = this.#lanes.flatMap(({ in: lane }) => {
      const topic = lane?.topicFor(address);
      return lane === undefined || topic === undefined ? [] : [{ lane, topic }];
    });
    if (this.#routes.size >= REMEMBERED_ADDRESSES) this.#routes.clear();
    this.#routes.set(address, routes);
    return routes;
  }
}
