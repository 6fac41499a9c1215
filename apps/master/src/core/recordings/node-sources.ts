import type { NodeRecorderClock, NodeRecorderFacts, RecordingSelection } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { Client } from '../clients/client.ts';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import type { RecordCollector } from './record-collector.ts';
import { CompiledSelection, type SelectionContext } from './selection.ts';
import type { NodeOrders } from './node-orders.ts';

/** What is needed to tell nodes what they record. */
export interface NodeSourcesContext extends SelectionContext {
  readonly clock: Clock;
  readonly clients: ClientRegistry;
  readonly topics: TopicTable;
  readonly collector: RecordCollector;
}

/** Told to a node for one recording; beyond it, it records what it knows. */
const MAX_SOURCES = 20_000;

/** Tells a node what only the master knows of a recording that it makes. [RC-61] */
export class NodeSources {
  readonly #context: NodeSourcesContext;
  readonly #recordingId: string;
  readonly #known = new Set<string>();
  readonly #needsMaster: boolean;
  readonly #selection: CompiledSelection;
  readonly #unwatch: () => void;
  #tell: (topic: string, clientId: string) => void = () => undefined;
  #clocksSinceMs = 0;
  #lost: { readonly count: number; readonly atMs: number } | undefined = undefined;

  constructor(context: NodeSourcesContext, recordingId: string, selection: RecordingSelection) {
    this.#context = context;
    this.#recordingId = recordingId;
    const { clients, devices, sessions } = selection;
    // Topics and globs are compared by the node itself.
    this.#needsMaster = [clients, devices, sessions].some((list) => list.length > 0);
    this.#selection = new CompiledSelection(selection, context);
    this.#unwatch = context.collector.watch({
      selection: this.#selection,
      onSource: (topic, clientId) => this.#found(topic, clientId, this.#tell),
    });
  }

  /** What there is to record now. */
  present(): { topic: string; clientId: string }[] {
    const found: { topic: string; clientId: string }[] = [];
    for (const { topic, isMasters, record, publisherId } of this.#context.topics.values()) {
      if (isMasters || record === undefined || !this.#selection.selects(topic, publisherId))
        continue;
      this.#found(topic, publisherId, () => found.push({ topic, clientId: publisherId }));
    }
    return found;
  }

  /** Tells the node of each that comes later. */
  tellNode(nodeId: string, orders: NodeOrders): void {
    const recordingId = this.#recordingId;
    this.#tell = (topic, clientId) =>
      orders.send(nodeId, { sources: { recordingId, elements: [{ topic, clientId }] } });
  }

  /** What has changed since the call before; undefined when nothing has. */
  takeFacts(node: Client): NodeRecorderFacts | undefined {
    const clocks = this.#takeClocks();
    const nowMs = this.#context.clock.nowMs();
    const { count } = node.subscriber.outbox.drops;
    const { count: before, atMs: lostFromMs } = this.#lost ?? { count, atMs: nowMs };
    this.#lost = { count, atMs: nowMs };
    const lostCount = count - before;
    if (clocks.length === 0 && lostCount <= 0) return undefined;
    return { clocks, lostCount: Math.max(0, lostCount), lostFromMs, lostUntilMs: nowMs };
  }

  close(): void {
    this.#unwatch();
  }

  #found(topic: string, clientId: string, tell: (topic: string, clientId: string) => void): void {
    if (!this.#needsMaster || this.#known.size >= MAX_SOURCES) return;
    const key = `${clientId} ${topic}`;
    if (this.#known.has(key)) return;
    this.#known.add(key);
    tell(topic, clientId);
  }

  /** [RC-14] */
  #takeClocks(): NodeRecorderClock[] {
    const { clients, clock } = this.#context;
    const sinceMs = this.#clocksSinceMs;
    const nowMs = clock.monotonicMs();
    this.#clocksSinceMs = nowMs;
    return [...clients.values()].flatMap(({ id, clock: told }) => {
      if (told === undefined || told.toldMs < sinceMs) return [];
      const { offsetMs, errorMs, driftPpm, toldMs } = told;
      return [{ clientId: id, clock: { offsetMs, errorMs, driftPpm, ageMs: nowMs - toldMs } }];
    });
  }
}
