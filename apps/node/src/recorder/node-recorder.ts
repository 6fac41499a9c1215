import type { ConnectionState, UbiiClient } from '@ubii/client-web/node';
import {
  RecordingState,
  ServiceError,
  type NodeRecorderOrder,
  type NodeRecorderStart,
  type Recording,
} from '@ubii/proto';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import { clockEvent, type Recorder } from '@ubii/recording/recorder';
import type { Log } from '@ubii/client-program';
import { followFacts, presentFacts } from './recorded-facts.ts';
import { RunningFeed } from './running-feed.ts';
import { Uploads } from './uploads.ts';

/** What the recorder of a node works with. */
export interface NodeRecorderContext {
  readonly client: UbiiClient;
  readonly recorder: Recorder;
  readonly log: Log;
  /** Uploads the file of a recording. @throws when that fails */
  send(id: string, signal: AbortSignal, onProgress: (bytes: number) => void): Promise<void>;
}

/** Bits by which the recorder tells recordings apart; that many run at once, as on the master. [RC-4] */
const TARGETS = [2, 4, 8, 16, 32, 64, 128, 256];
/** The longest time that a report may be behind while something is uploaded, milliseconds. */
const UPLOAD_REPORT_MS = 1_000;

type Answer = {
  readonly recording?: Recording;
  readonly marker?: NonNullable<NodeRecorderOrder['mark']>['marker'];
};

/** Makes recordings for the master on this machine, and uploads them. [RC-60] */
export class NodeRecorder {
  readonly #context: NodeRecorderContext;
  readonly #feeds = new Map<string, RunningFeed>();
  readonly #uploads: Uploads;
  readonly #ends: (() => void)[] = [];
  #endFacts: (() => void) | undefined;
  #orders: Promise<void> = Promise.resolve();
  #reports: Promise<void> = Promise.resolve();
  #isConnected = false;

  constructor(context: NodeRecorderContext) {
    const { client, recorder, send } = context;
    this.#context = context;
    this.#uploads = new Uploads({
      send: (id, signal, onProgress) => send(id, signal, onProgress),
      handleSent: (id) => this.#handleSent(id),
      onChange: () => void this.report(),
    });
    recorder.onState(({ running }) => {
      const now = new Set(running.map(({ id }) => id));
      for (const id of this.#feeds.keys()) if (!now.has(id)) this.#handleEnd(id);
      void this.report();
    });
    this.#ends.push(
      client.onNodeMessage(({ recorderOrder: order }) => {
        // One after the other: a marker belongs to the recording that was started before it.
        if (order !== undefined) this.#orders = this.#orders.then(() => this.#handle(order));
      }),
      client.onState((state) => this.#handleState(state)),
    );
    const timer = setInterval(() => {
      if (this.#uploads.isSending) void this.report();
    }, UPLOAD_REPORT_MS);
    timer.unref();
    this.#ends.push(() => clearInterval(timer));
  }

  /** Tells the master of all recordings that are here. [RC-62] */
  report(): Promise<void> {
    const { log } = this.#context;
    this.#reports = this.#reports
      .then(() => this.#sendReport())
      .catch((error: unknown) => log('error', `Recordings cannot be listed: ${String(error)}`));
    return this.#reports;
  }

  async #sendReport(): Promise<void> {
    const { client, recorder } = this.#context;
    if (!this.#isConnected) return;
    const { recordings } = await recorder.list();
    const elements = recordings.map((one) => this.#describe(one));
    client.sendNodeMessage(encodeNodeMessageFrame({ recorderReport: { elements } }));
  }

  /** Closes all files. What is not uploaded is uploaded by the next run. */
  async close(): Promise<void> {
    for (const end of this.#ends) end();
    this.#isConnected = false;
    for (const id of [...this.#feeds.keys()]) this.#endFeed(id);
    await this.#orders;
    await Promise.all([this.#uploads.close(), this.#context.recorder.close()]);
  }

  #handleState({ status }: ConnectionState): void {
    const isConnected = status === 'connected';
    if (isConnected === this.#isConnected) return;
    this.#isConnected = isConnected;
    for (const feed of this.#feeds.values()) feed.handleConnection(isConnected);
    if (!isConnected) return;
    void this.report()
      .then(() => this.#uploadAll())
      .catch(() => undefined); // The report said why.
  }

  async #uploadAll(): Promise<void> {
    const { recordings } = await this.#context.recorder.list();
    for (const { id, state } of recordings) {
      if (!isRunning(state) && !isRejected(state)) this.#uploads.add(id);
    }
  }

  async #handle(order: NodeRecorderOrder): Promise<void> {
    const { client } = this.#context;
    let answer: Answer = {};
    let error: ServiceError | undefined;
    try {
      answer = await this.#carryOut(order);
    } catch (cause) {
      error = ServiceError.from(cause);
    }
    if (order.number === 0) return;
    const recorderAnswer = { number: order.number, ...answer, error: error?.toWire() };
    client.sendNodeMessage(encodeNodeMessageFrame({ recorderAnswer }));
  }

  /** [RC-61] */
  async #carryOut(order: NodeRecorderOrder): Promise<Answer> {
    const { recorder } = this.#context;
    const { start, stop, get, change, remove, mark, upload, sources, facts } = order;
    if (start !== undefined) return { recording: await this.#start(start) };
    if (stop !== undefined) {
      // What has come until now belongs to it.
      this.#feeds.get(stop.id)?.close();
      return { recording: this.#describe(await recorder.stop(stop.id)) };
    }
    if (get !== undefined) {
      const { recording } = await recorder.get(get.id, get);
      return { recording: this.#describe(recording) };
    }
    if (change !== undefined) {
      return { recording: this.#describe(await recorder.change(change.id, change)) };
    }
    if (remove !== undefined) {
      this.#endFeed(remove.id);
      this.#uploads.forget(remove.id);
      await recorder.delete(remove.id);
    }
    if (mark?.marker !== undefined) {
      const { marker, mayChangeAll, isTopic } = mark;
      const kind = isTopic ? 'topic' : 'service';
      return { marker: await recorder.mark({ marker, mayChangeAll, kind }) };
    }
    if (upload !== undefined) {
      const { recording } = await recorder.get(upload.id);
      if (isRejected(recording.state)) {
        throw new ServiceError('failed_precondition', recording.problem);
      }
      this.#uploads.add(upload.id);
      return { recording: this.#describe(recording) };
    }
    if (sources !== undefined) this.#feeds.get(sources.recordingId)?.addSources(sources.elements);
    if (facts !== undefined) this.#addFacts(facts);
    return {};
  }

  async #start(start: NodeRecorderStart): Promise<Recording> {
    const { client, recorder, log } = this.#context;
    const { recording, makerId, masterName, version, personalData, sources, facts } = start;
    const selection = recording?.selection;
    const budget = recording?.budget;
    if (recording === undefined || selection === undefined || budget === undefined) {
      throw new ServiceError(
        'invalid_argument',
        'The order of the master has no selection or budget.',
      );
    }
    const { id, name, notes, author, study, replayedRecordingId } = recording;
    const target = this.#freeTarget();
    const started = await recorder.start({
      id,
      name,
      notes,
      author,
      study,
      makerId,
      masterName,
      version,
      personalData,
      ...(replayedRecordingId === '' ? {} : { replayedRecordingId }),
      target,
      selection,
      budget,
      present: await presentFacts(client),
    });
    const feed = new RunningFeed({ client, recorder, target }, selection);
    this.#feeds.set(id, feed);
    this.#endFacts ??= followFacts(client, (event) => recorder.addEvent(event, this.#targets()));
    if (sources !== undefined) feed.addSources(sources.elements);
    if (facts !== undefined) this.#addFacts(facts);
    log('info', `Recording "${name}" for ${author || masterName}`);
    return this.#describe(started);
  }

  #freeTarget(): number {
    const used = this.#targets();
    const free = TARGETS.find((target) => (used & target) === 0);
    if (free !== undefined) return free;
    throw new ServiceError(
      'resource_exhausted',
      `This node makes ${TARGETS.length} recordings already. Stop one of them first.`,
    );
  }

  #targets(): number {
    return [...this.#feeds.values()].reduce((bits, { target }) => bits | target, 0);
  }

  #addFacts(facts: NonNullable<NodeRecorderOrder['facts']>): void {
    const { client, recorder } = this.#context;
    const nowMs = client.masterTime.nowMs();
    for (const { clientId, clock } of facts.clocks) {
      if (clock !== undefined)
        recorder.addEvent(clockEvent(clientId, clock, nowMs), this.#targets());
    }
    if (facts.lostCount <= 0) return;
    const { lostFromMs, lostUntilMs, lostCount } = facts;
    for (const feed of this.#feeds.values()) feed.addLoss(lostFromMs, lostUntilMs, lostCount);
  }

  #endFeed(id: string): void {
    this.#feeds.get(id)?.close();
    this.#feeds.delete(id);
    if (this.#feeds.size > 0) return;
    this.#endFacts?.();
    this.#endFacts = undefined;
  }

  /** It was stopped, reached a limit, or could not be written. */
  #handleEnd(id: string): void {
    this.#endFeed(id);
    this.#context.log('info', `The recording ${id} has ended`);
    this.#uploads.add(id);
  }

  /** The file is at the master. [RC-63] */
  async #handleSent(id: string): Promise<void> {
    await this.#context.recorder.delete(id);
    this.#context.log('info', `The recording ${id} is on the master`);
  }

  #describe(recording: Recording): Recording {
    const { id, problem } = recording;
    const upload = this.#uploads.problemOf(id);
    return {
      ...recording,
      problem: [problem, upload].filter((text) => text !== '').join(' '),
      uploadedBytes: this.#uploads.sentBytesOf(id),
    };
  }
}

/** Its file cannot be read, and stays here until it is deleted. [RC-45] */
function isRejected(state: RecordingState): boolean {
  return state === RecordingState.RECORDING_STATE_REJECTED;
}

function isRunning(state: RecordingState): boolean {
  return state === RecordingState.RECORDING_STATE_RECORDING;
}
