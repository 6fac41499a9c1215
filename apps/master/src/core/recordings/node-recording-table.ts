import { RecordingState, ServiceError, type Recording } from '@ubii/proto';
import type { GrantId } from '../access/grant.ts';
import type { Client } from '../clients/client.ts';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { isAway } from '../nodes/node-requests.ts';
import { quote } from '../texts/quote.ts';
import type { NodeSources } from './node-sources.ts';

/** A recording that a node makes, or has and has not uploaded yet. */
export interface NodeRecording {
  recording: Recording;
  readonly makerId: string;
  readonly author: string;
  /** Id of the invitation of its node. */
  readonly nodeMakerId: GrantId | undefined;
  /** Undefined when it has ended. */
  sources: NodeSources | undefined;
}

/** What the table works with. */
export interface NodeRecordingTableContext {
  readonly clients: ClientRegistry;
  readonly limits: LimitWatch;
}

/** Recordings at nodes by id, as many as may be. [RC-65] */
export class NodeRecordingTable {
  readonly #context: NodeRecordingTableContext;
  readonly #entries = new Map<string, NodeRecording>();

  constructor(context: NodeRecordingTableContext) {
    this.#context = context;
  }

  get(id: string): NodeRecording | undefined {
    return this.#entries.get(id);
  }

  /** @throws ServiceError when there is none with this id */
  require(id: string): NodeRecording {
    const entry = this.#entries.get(id);
    if (entry !== undefined) return entry;
    throw new ServiceError('not_found', `No node has a recording with the id "${id}".`);
  }

  /** Those of one node. */
  ofNode(nodeId: string): [id: string, entry: NodeRecording][] {
    return [...this.#entries].filter(([, { recording }]) => recording.nodeId === nodeId);
  }

  add(id: string, entry: NodeRecording): void {
    this.#entries.set(id, entry);
  }

  drop(id: string): void {
    this.#entries.get(id)?.sources?.close();
    this.#entries.delete(id);
  }

  get hasRoom(): boolean {
    return this.#entries.size < this.#context.limits.limits.recordingsAtNodes;
  }

  /** @throws ServiceError when there are as many as may be */
  requireRoom(nodeId: string): void {
    if (this.hasRoom) return;
    const { limits } = this.#context;
    const text = `more than ${limits.limits.recordingsAtNodes} recordings at nodes`;
    throw limits.refusal('recordingsAtNodes', text, nodeId);
  }

  /** As clients see them, the newest first. */
  list(): Recording[] {
    const all = [...this.#entries.values()].map((entry) => this.describe(entry));
    return all.filter((recording) => !isBeingStarted(recording)).reverse();
  }

  describe({ recording }: NodeRecording): Recording {
    const nodeIsAway = this.#context.clients.get(recording.nodeId)?.socket === undefined;
    return { ...recording, nodeIsAway };
  }

  /** @throws ServiceError when its node is away */
  presentNode({ recording }: NodeRecording): Client {
    const node = this.#context.clients.get(recording.nodeId);
    if (node?.socket === undefined) throw isAway(quote(recording.nodeName));
    return node;
  }
}

export function isRunning({ state }: Recording): boolean {
  return state === RecordingState.RECORDING_STATE_RECORDING;
}

/** Its node has not confirmed the recording yet. */
export function isBeingStarted({ state }: Recording): boolean {
  return state === RecordingState.RECORDING_STATE_UNSPECIFIED;
}
