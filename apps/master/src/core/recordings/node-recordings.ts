import {
  RecordingState,
  ServiceError,
  type NodeRecorderAnswer,
  type NodeRecorderReport,
  type Recording,
  type RecordingBudget,
  type RecordingSelection,
} from '@ubii/proto';
import type {
  KeptRecording,
  MarkerJob,
  RecordingJob,
  RecordingTexts,
} from '@ubii/recording/recorder';
import { makerOfAccess, type Caller } from '../access/caller.ts';
import type { Client } from '../clients/client.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { Hook } from '../hooks/hook.ts';
import { cutTexts } from '../texts/bound-texts.ts';
import { quote } from '../texts/quote.ts';
import { isAway, NodeOrders } from './node-orders.ts';
import { mayRecord, requireEnd, requireRecorder, requireUploader } from './recorder-nodes.ts';
import { NodeSources, type NodeSourcesContext } from './node-sources.ts';
import { isRecordingId, newRecording, reportedRecording } from './reported-recording.ts';

/** What recordings at nodes work with. */
export interface NodeRecordingsContext extends NodeSourcesContext {
  readonly limits: LimitWatch;
}

interface Entry {
  recording: Recording;
  readonly makerId: string;
  readonly author: string;
  /** Id of the invitation of its node. */
  readonly nodeMakerId: string;
  sources: NodeSources | undefined;
}

/** What is kept of who wanted a recording, for its upload. */
export type WishedFacts = Pick<RecordingJob, 'name' | 'author' | 'makerId'>;

/** Recordings that are deleted while their node is away, until it returns. */
const MAX_DELETED = 1_000;

/** Recordings that nodes make, or have and have not uploaded yet. [RC-60] */
export class NodeRecordings {
  readonly #context: NodeRecordingsContext;
  readonly #orders: NodeOrders;
  readonly #entries = new Map<string, Entry>();
  /** Their nodes are told when they return. */
  readonly #deleted = new Set<string>();
  /** Called when one has begun, changed or gone. @param isListChanged false: only numbers of running ones */
  readonly onChange = new Hook<[isListChanged: boolean]>();

  constructor(context: NodeRecordingsContext) {
    this.#context = context;
    this.#orders = new NodeOrders(context);
    context.clients.onPresence.add((client) => this.#handlePresence(client));
  }

  /** The newest first. */
  list(): Recording[] {
    const all = [...this.#entries.values()].map((entry) => this.#describe(entry));
    return all.filter((recording) => !isBeingStarted(recording)).reverse();
  }

  running(): Recording[] {
    return this.list().filter(isRunning);
  }

  has(id: string): boolean {
    return this.#entries.has(id);
  }

  /** With topics and markers, as long as its node is there. */
  async get(id: string): Promise<KeptRecording> {
    const entry = this.#require(id);
    const kept = { recording: this.#describe(entry), makerId: entry.makerId };
    if (kept.recording.nodeIsAway) return kept;
    const { recording } = await this.#orders.ask(entry.recording.nodeId, { get: { id } });
    const { topics = [], markers = [] } = recording ?? {};
    return { ...kept, recording: { ...kept.recording, topics, markers } };
  }

  /** @throws ServiceError when the node does not record for the master, or refuses [RC-60] */
  async start(
    job: RecordingJob,
    what: { selection: RecordingSelection; budget: RecordingBudget },
    nodeId: string,
  ): Promise<Recording> {
    const node = requireRecorder(this.#context.clients, nodeId);
    this.#requireRoom(nodeId);
    const { makerId, masterName, version, personalData } = job;
    const sources = new NodeSources(this.#context, job.id, what.selection);
    const entry = {
      recording: { ...newRecording(job, this.#context.clock.nowMs()), ...what, nodeId },
      ...{ makerId, author: job.author, nodeMakerId: makerOfAccess(node.access), sources },
    };
    const start = {
      ...{ recording: entry.recording, makerId, masterName, version, personalData },
      sources: { recordingId: job.id, elements: sources.present() },
      facts: sources.takeFacts(node),
    };
    // From now on it is counted, and what its node says of it is believed.
    this.#entries.set(job.id, entry);
    sources.tellNode(nodeId, this.#orders);
    try {
      this.#take(entry, node, await this.#orders.ask(nodeId, { start }));
    } catch (cause) {
      this.#drop(job.id);
      // The node may have begun before its answer got lost.
      this.#orders.tell(nodeId, { remove: { id: job.id } });
      throw cause;
    }
    this.onChange.emit(true);
    return this.#describe(entry);
  }

  stop(id: string): Promise<Recording> {
    return this.#change(id, { stop: { id } });
  }

  change(id: string, texts: RecordingTexts): Promise<Recording> {
    return this.#change(id, { change: { id, ...texts } });
  }

  /** Asks the node to upload its file now. [RC-63] */
  upload(id: string): Promise<Recording> {
    requireEnd(this.#require(id).recording);
    return this.#change(id, { upload: { id } });
  }

  /** Of a node that is away, it is deleted when the node returns. [RC-64] */
  async delete(id: string): Promise<void> {
    const { recording } = this.#require(id);
    if (this.#context.clients.get(recording.nodeId)?.socket === undefined) {
      if (this.#deleted.size >= MAX_DELETED) throw isAway(quote(recording.nodeName));
      this.#deleted.add(id);
    } else {
      await this.#orders.ask(recording.nodeId, { remove: { id } });
    }
    this.#drop(id);
    this.onChange.emit(true);
  }

  /** Marks one, or all that run at nodes that are there. [RC-20] @returns whether there was one */
  async mark({ marker, kind, mayChangeAll }: MarkerJob): Promise<boolean> {
    const { recordingId } = marker;
    const one = this.#entries.get(recordingId);
    if (one !== undefined) {
      const mark = { marker, mayChangeAll };
      await this.#orders.ask(this.#presentNode(one).id, { mark });
      return true;
    }
    if (recordingId !== '') return false;
    const running = this.running().filter(({ nodeIsAway }) => !nodeIsAway);
    for (const nodeId of new Set(running.map((recording) => recording.nodeId))) {
      this.#orders.tell(nodeId, { mark: { marker, mayChangeAll, isTopic: kind === 'topic' } });
    }
    return running.length > 0;
  }

  /**
   * Whether this caller may bring the file of a recording. [RC-63]
   *
   * @throws ServiceError when it is not its node
   */
  requireUpload(id: string, clientId: string, caller: Caller): WishedFacts {
    const { recording, author, makerId } = this.#require(id);
    requireUploader(recording, clientId, caller);
    const { name } = recording;
    return { name, author, makerId };
  }

  /** Its file is at the master now. */
  handleUploaded(id: string): void {
    this.#drop(id);
    this.onChange.emit(true);
  }

  handleAnswer(client: Client, answer: NodeRecorderAnswer): void {
    this.#orders.handleAnswer(client.id, answer);
  }

  /** [RC-62] */
  handleReport(client: Client, report: NodeRecorderReport): void {
    const { clock } = this.#context;
    if (!mayRecord(client) || !client.recordBudget.take(1, clock.monotonicMs())) return;
    const elements = this.#bounded(report.elements);
    if (elements === undefined) return;
    const told = new Set(elements.map(({ id }) => id));
    let isListChanged = false;
    for (const [id, { recording }] of this.#entries) {
      // One that is being started is not told of yet.
      if (recording.nodeId !== client.id || told.has(id) || isBeingStarted(recording)) continue;
      this.#drop(id);
      isListChanged = true;
    }
    for (const recording of elements) {
      if (this.#takeReported(client, recording)) isListChanged = true;
    }
    for (const { recording, sources } of this.#entries.values()) {
      const facts =
        recording.nodeId === client.id && isRunning(recording) && sources?.takeFacts(client);
      if (facts) this.#orders.tell(client.id, { facts });
    }
    this.onChange.emit(isListChanged);
  }

  close(): void {
    this.#orders.close();
  }

  /** @returns whether it is new, or has ended */
  #takeReported(client: Client, told: Recording): boolean {
    const { id } = told;
    if (!isRecordingId(id)) return false;
    if (this.#deleted.has(id)) {
      this.#deleted.delete(id);
      this.#orders.tell(client.id, { remove: { id } });
      return false;
    }
    let entry = this.#entries.get(id);
    const isNew = entry === undefined;
    if (entry === undefined) {
      if (!this.#hasRoom()) return false;
      const makerId = makerOfAccess(client.access);
      entry = {
        ...{ recording: told, makerId, author: told.author },
        ...{ nodeMakerId: makerId, sources: undefined },
      };
      this.#entries.set(id, entry);
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
  #isSuccessor(entry: Entry, { access }: Client): boolean {
    return this.#describe(entry).nodeIsAway && entry.nodeMakerId === makerOfAccess(access);
  }

  /** Tells the node who publishes what it records, while it records. */
  #follow(entry: Entry, { id: nodeId }: Client): void {
    const { recording } = entry;
    if (!isRunning(recording)) {
      entry.sources?.close();
      entry.sources = undefined;
      return;
    }
    entry.sources?.tellNode(nodeId, this.#orders);
    if (entry.sources === undefined && recording.selection !== undefined) {
      // The master was started again meanwhile.
      entry.sources = new NodeSources(this.#context, recording.id, recording.selection);
      entry.sources.tellNode(nodeId, this.#orders);
      const elements = entry.sources.present();
      this.#orders.tell(nodeId, { sources: { recordingId: recording.id, elements } });
    }
  }

  async #change(id: string, order: Parameters<NodeOrders['ask']>[1]): Promise<Recording> {
    const entry = this.#require(id);
    const node = this.#presentNode(entry);
    const answer = await this.#orders.ask(node.id, order);
    // Its upload may be over before its answer is read.
    const taken = this.#take(entry, node, answer);
    if (this.#entries.has(id)) this.onChange.emit(true);
    return taken;
  }

  #take(entry: Entry, node: Client, { recording }: NodeRecorderAnswer): Recording {
    if (recording !== undefined) {
      const [told] = this.#bounded([recording]) ?? [];
      if (told !== undefined) entry.recording = reportedRecording(told, entry, node);
      this.#follow(entry, node);
    }
    return this.#describe(entry);
  }

  /** What a node said, with texts as long as they may be; undefined when it has a name or id that is too long. */
  #bounded(elements: readonly Recording[]): readonly Recording[] | undefined {
    const { limits } = this.#context.limits;
    try {
      return elements.map((one) => cutTexts('ubii.extension.Recording', one, limits));
    } catch {
      return undefined;
    }
  }

  #describe({ recording }: Entry): Recording {
    const nodeIsAway = this.#context.clients.get(recording.nodeId)?.socket === undefined;
    return { ...recording, nodeIsAway };
  }

  #presentNode({ recording }: Entry): Client {
    const node = this.#context.clients.get(recording.nodeId);
    if (node?.socket === undefined) throw isAway(quote(recording.nodeName));
    return node;
  }

  #handlePresence({ id, label, socket }: Client): void {
    if (socket === undefined) this.#orders.handleGone(id, quote(label));
    const isConcerned = [...this.#entries.values()].some(
      ({ recording }) => recording.nodeId === id,
    );
    if (isConcerned) this.onChange.emit(true);
  }

  #drop(id: string): void {
    this.#entries.get(id)?.sources?.close();
    this.#entries.delete(id);
  }

  #require(id: string): Entry {
    const entry = this.#entries.get(id);
    if (entry !== undefined) return entry;
    throw new ServiceError('not_found', `No node has a recording with the id "${id}".`);
  }

  #hasRoom(): boolean {
    return this.#entries.size < this.#context.limits.limits.recordingsAtNodes;
  }

  #requireRoom(nodeId: string): void {
    if (this.#hasRoom()) return;
    const max = this.#context.limits.limits.recordingsAtNodes;
    throw this.#context.limits.refusal(
      'recordingsAtNodes',
      `more than ${max} recordings at nodes`,
      nodeId,
    );
  }
}

function isRunning({ state }: Recording): boolean {
  return state === RecordingState.RECORDING_STATE_RECORDING;
}

function isBeingStarted({ state }: Recording): boolean {
  return state === RecordingState.RECORDING_STATE_UNSPECIFIED;
}
