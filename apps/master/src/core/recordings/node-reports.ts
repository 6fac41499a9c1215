import type { NodeRecorderAnswer, NodeRecorderReport, Recording } from '@ubii/proto';
import { grantOfAccess } from '../access/caller.ts';
import type { Client } from '../clients/client.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { cutTexts } from '../texts/bound-texts.ts';
import type { NodeOrders } from './node-orders.ts';
import {
  isBeingStarted,
  isRunning,
  type NodeRecording,
  type NodeRecordingTable,
} from './node-recording-table.ts';
import { NodeSources, type NodeSourcesContext } from './node-sources.ts';
import { mayRecord } from './recorder-nodes.ts';
import { isRecordingId, reportedRecording } from './reported-recording.ts';

/** What reports work with. */
export interface NodeReportsContext extends NodeSourcesContext {
  readonly limits: LimitWatch;
  readonly orders: NodeOrders;
  readonly table: NodeRecordingTable;
}

/** Recordings that are deleted while their node is away, until it returns. */
const MAX_DELETED = 1_000;

/** Reports of nodes on their recordings, and facts about publishers for nodes that record. [RC-61] [RC-62] */
export class NodeReports {
  readonly #context: NodeReportsContext;
  /** Deletions for nodes that are not connected. */
  readonly #deleted = new Set<string>();

  constructor(context: NodeReportsContext) {
    this.#context = context;
  }

  /** Takes what a node answers about one. */
  takeAnswer(entry: NodeRecording, node: Client, { recording }: NodeRecorderAnswer): Recording {
    if (recording !== undefined) {
      const [told] = this.#bounded([recording]) ?? [];
      if (told !== undefined) entry.recording = reportedRecording(told, entry, node);
      this.#follow(entry, node);
    }
    return this.#context.table.describe(entry);
  }

  /** Takes the list of a node. @returns whether the list of recordings changed; undefined when it is not taken */
  takeReport(client: Client, report: NodeRecorderReport): boolean | undefined {
    const { clock, orders, table } = this.#context;
    if (!mayRecord(client) || !client.recordBudget.take(1, clock.monotonicMs())) return undefined;
    const elements = this.#bounded(report.elements);
    if (elements === undefined) return undefined;
    let isListChanged = this.#dropUntold(client, new Set(elements.map(({ id }) => id)));
    for (const recording of elements) {
      if (this.#takeReported(client, recording)) isListChanged = true;
    }
    for (const [, { recording, sources }] of table.ofNode(client.id)) {
      const facts = isRunning(recording) && sources?.takeFacts(client);
      if (facts) orders.send(client.id, { facts });
    }
    return isListChanged;
  }

  /** Deletes one when its node returns. [RC-64] @returns false when there are too many of them */
  deleteOnReturn(id: string): boolean {
    if (this.#deleted.size >= MAX_DELETED) return false;
    this.#deleted.add(id);
    return true;
  }

  /** @returns whether there were any */
  #dropUntold(client: Client, told: ReadonlySet<string>): boolean {
    const { table } = this.#context;
    // A recording that is starting is not reported yet.
    const gone = table
      .ofNode(client.id)
      .filter(([id, { recording }]) => !told.has(id) && !isBeingStarted(recording));
    for (const [id] of gone) table.drop(id);
    return gone.length > 0;
  }

  /** @returns whether it is new, or has ended */
  #takeReported(client: Client, told: Recording): boolean {
    const { orders, table } = this.#context;
    const { id } = told;
    if (!isRecordingId(id)) return false;
    if (this.#deleted.has(id)) {
      this.#deleted.delete(id);
      orders.send(client.id, { remove: { id } });
      return false;
    }
    let entry = table.get(id);
    const isNew = entry === undefined;
    if (entry === undefined) {
      if (!table.hasRoom) return false;
      // Whose it is, the master alone knew, which was started again: an admin's. [RC-66]
      entry = {
        recording: told,
        makerId: '',
        author: told.author,
        nodeMakerId: grantOfAccess(client.access),
        sources: undefined,
      };
      table.add(id, entry);
    } else if (entry.recording.nodeId !== client.id && !this.#isSuccessor(entry, client)) {
      return false; // Of another node.
    }
    const before = entry.recording;
    entry.recording = reportedRecording(told, entry, client);
    this.#follow(entry, client);
    return (
      isNew || before.state !== entry.recording.state || before.problem !== entry.recording.problem
    );
  }

  /** Whether a client is the node of a recording that lost its identity. */
  #isSuccessor(entry: NodeRecording, { access }: Client): boolean {
    const { nodeIsAway } = this.#context.table.describe(entry);
    return nodeIsAway && entry.nodeMakerId === grantOfAccess(access);
  }

  /** Tells the node who publishes what it records, while it records. */
  #follow(entry: NodeRecording, { id: nodeId }: Client): void {
    const { orders } = this.#context;
    const { recording } = entry;
    if (!isRunning(recording)) {
      entry.sources?.close();
      entry.sources = undefined;
      return;
    }
    entry.sources?.tellNode(nodeId, orders);
    if (entry.sources === undefined && recording.selection !== undefined) {
      // The master was started again meanwhile.
      entry.sources = new NodeSources(this.#context, recording.id, recording.selection);
      entry.sources.tellNode(nodeId, orders);
      const elements = entry.sources.present();
      orders.send(nodeId, { sources: { recordingId: recording.id, elements } });
    }
  }

  #bounded(elements: readonly Recording[]): readonly Recording[] | undefined {
    const bounded = elements.flatMap((one) => this.bounded(one) ?? []);
    return bounded.length < elements.length ? undefined : bounded;
  }

  /**
   * What a node said, with texts as long as they may be, and without what only the master knows: a node cannot make a
   * recording part of a study, or a comparison. [RC-63] Undefined when it has an id or topic that is too long.
   */
  bounded(told: Recording): Recording | undefined {
    const { limits } = this.#context.limits;
    try {
      const bounded = cutTexts('ubii.extension.Recording', told, limits);
      return { ...bounded, study: undefined, replayedRecordingId: '' };
    } catch {
      return undefined;
    }
  }
}
