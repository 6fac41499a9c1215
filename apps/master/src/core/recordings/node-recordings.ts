import type {
  NodeRecorderAnswer,
  NodeRecorderReport,
  Recording,
  RecordingBudget,
  RecordingSelection,
} from '@ubii/proto';
import type {
  KeptRecording,
  MarkerJob,
  RecordingJob,
  RecordingPage,
  RecordingTexts,
} from '@ubii/recording/recorder';
import { grantOfAccess, type Caller } from '../access/caller.ts';
import type { Client } from '../clients/client.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { Hook } from '../hooks/hook.ts';
import { isAway } from '../nodes/node-requests.ts';
import { quote } from '../texts/quote.ts';
import { createNodeOrders, type NodeOrder, type NodeOrders } from './node-orders.ts';
import { isRunning, NodeRecordingTable } from './node-recording-table.ts';
import { NodeReports } from './node-reports.ts';
import { NodeSources, type NodeSourcesContext } from './node-sources.ts';
import { requireEnd, requireRecorder, requireUploader } from './recorder-nodes.ts';
import { newRecording, reportedPage } from './reported-recording.ts';

/** What recordings at nodes work with. */
export interface NodeRecordingsContext extends NodeSourcesContext {
  readonly limits: LimitWatch;
}

/** What is kept of who wanted a recording, for its upload. */
export type WishedFacts = Pick<
  RecordingJob,
  'name' | 'author' | 'makerId' | 'study' | 'replayedRecordingId'
>;

/** Recordings that nodes make, or have and have not uploaded yet. [RC-60] */
export class NodeRecordings {
  readonly #context: NodeRecordingsContext;
  readonly #orders: NodeOrders;
  readonly #table: NodeRecordingTable;
  readonly #reports: NodeReports;
  /** Called when one has begun, changed or gone. @param isListChanged false: only numbers of running ones */
  readonly onChange = new Hook<[isListChanged: boolean]>();

  constructor(context: NodeRecordingsContext) {
    this.#context = context;
    this.#orders = createNodeOrders(context);
    this.#table = new NodeRecordingTable(context);
    this.#reports = new NodeReports({ ...context, orders: this.#orders, table: this.#table });
    context.clients.onPresence.add((client) => this.#handlePresence(client));
  }

  /** The newest first. */
  list(): Recording[] {
    return this.#table.list();
  }

  running(): Recording[] {
    return this.list().filter(isRunning);
  }

  has(id: string): boolean {
    return this.#table.get(id) !== undefined;
  }

  /** @param page of topics and markers, as long as its node is there; default: none of them */
  async get(id: string, page?: RecordingPage): Promise<KeptRecording> {
    const entry = this.#table.require(id);
    const kept = { recording: this.#table.describe(entry), makerId: entry.makerId };
    if (page === undefined || kept.recording.nodeIsAway) return kept;
    const answer = await this.#orders.ask(entry.recording.nodeId, { get: { id, ...page } });
    const told = answer.recording && this.#reports.bounded(answer.recording);
    if (told === undefined) return kept;
    return { ...kept, recording: { ...kept.recording, ...reportedPage(told, page) } };
  }

  /** Whose it is. [RC-66] @throws ServiceError when there is none with this id */
  makerOf(id: string): string {
    return this.#table.require(id).makerId;
  }

  /** @throws ServiceError when the node does not record for the master, or refuses [RC-60] */
  async start(
    job: RecordingJob,
    what: { selection: RecordingSelection; budget: RecordingBudget },
    nodeId: string,
  ): Promise<Recording> {
    const node = requireRecorder(this.#context.clients, nodeId);
    this.#table.requireRoom(nodeId);
    const { makerId, masterName, version, personalData } = job;
    const sources = new NodeSources(this.#context, job.id, what.selection);
    const entry = {
      recording: { ...newRecording(job, this.#context.clock.nowMs()), ...what, nodeId },
      makerId,
      author: job.author,
      nodeMakerId: grantOfAccess(node.access),
      sources,
    };
    const start = {
      recording: entry.recording,
      makerId,
      masterName,
      version,
      personalData,
      sources: { recordingId: job.id, elements: sources.present() },
      facts: sources.takeFacts(node),
    };
    // From now on it is counted, and what its node says of it is believed.
    this.#table.add(job.id, entry);
    sources.tellNode(nodeId, this.#orders);
    try {
      this.#reports.takeAnswer(entry, node, await this.#orders.ask(nodeId, { start }));
    } catch (cause) {
      this.#table.drop(job.id);
      // The node may have begun before its answer got lost.
      this.#orders.send(nodeId, { remove: { id: job.id } });
      throw cause;
    }
    this.onChange.emit(true);
    return this.#table.describe(entry);
  }

  stop(id: string): Promise<Recording> {
    return this.#change(id, { stop: { id } });
  }

  change(id: string, texts: RecordingTexts): Promise<Recording> {
    return this.#change(id, { change: { id, ...texts } });
  }

  /** Asks the node to upload its file now. [RC-63] */
  upload(id: string): Promise<Recording> {
    requireEnd(this.#table.require(id).recording);
    return this.#change(id, { upload: { id } });
  }

  /** Of a node that is away, it is deleted when the node returns. [RC-64] */
  async delete(id: string): Promise<void> {
    const { recording } = this.#table.require(id);
    if (this.#context.clients.get(recording.nodeId)?.socket === undefined) {
      if (!this.#reports.deleteOnReturn(id)) throw isAway(quote(recording.nodeName));
    } else {
      await this.#orders.ask(recording.nodeId, { remove: { id } });
    }
    this.#table.drop(id);
    this.onChange.emit(true);
  }

  /** Marks one, or all that run at nodes that are there. [RC-20] @returns whether there was one */
  async mark({ marker, kind, mayChangeAll }: MarkerJob): Promise<boolean> {
    const { recordingId } = marker;
    const one = this.#table.get(recordingId);
    if (one !== undefined) {
      const mark = { marker, mayChangeAll };
      await this.#orders.ask(this.#table.presentNode(one).id, { mark });
      return true;
    }
    if (recordingId !== '') return false;
    const running = this.running().filter(({ nodeIsAway }) => !nodeIsAway);
    for (const nodeId of new Set(running.map((recording) => recording.nodeId))) {
      this.#orders.send(nodeId, { mark: { marker, mayChangeAll, isTopic: kind === 'topic' } });
    }
    return running.length > 0;
  }

  /**
   * Whether this caller may bring the file of a recording. [RC-63]
   *
   * @throws ServiceError when it is not its node
   */
  requireUpload(id: string, clientId: string, caller: Caller): WishedFacts {
    const { recording, author, makerId } = this.#table.require(id);
    requireUploader(recording, clientId, caller);
    const { name, study, replayedRecordingId } = recording;
    return { name, author, makerId, study, replayedRecordingId };
  }

  /** Its file is at the master now. */
  handleUploaded(id: string): void {
    this.#table.drop(id);
    this.onChange.emit(true);
  }

  handleAnswer(client: Client, answer: NodeRecorderAnswer): void {
    this.#orders.handleAnswer(client.id, answer);
  }

  /** [RC-62] */
  handleReport(client: Client, report: NodeRecorderReport): void {
    const isListChanged = this.#reports.takeReport(client, report);
    if (isListChanged !== undefined) this.onChange.emit(isListChanged);
  }

  close(): void {
    this.#orders.close();
  }

  async #change(id: string, order: NodeOrder): Promise<Recording> {
    const entry = this.#table.require(id);
    const node = this.#table.presentNode(entry);
    const answer = await this.#orders.ask(node.id, order);
    // Its upload may be over before its answer is read.
    const taken = this.#reports.takeAnswer(entry, node, answer);
    if (this.has(id)) this.onChange.emit(true);
    return taken;
  }

  #handlePresence({ id, label, socket }: Client): void {
    if (socket === undefined) this.#orders.handleGone(id, quote(label));
    if (this.#table.ofNode(id).length > 0) this.onChange.emit(true);
  }
}
