import type { EncodedRecord, UbiiClient } from '@ubii/client-web/node';
import type { NodeRecorderSource, RecordingSelection } from '@ubii/proto';
import { gapEvent, OpenBatch, type BatchedSource, type Recorder } from '@ubii/recording/recorder';
import { RecordedTopics } from './recorded-topics.ts';

/** Bytes of records that wait for the file; beyond, records are lost and counted, as on the master. [RC-19] */
const MAX_WAITING_BYTES = 32 * 1024 * 1024;
/** Longest time that records wait to be handed over, milliseconds. */
const BATCH_MS = 50;
/** Bytes from which on they are handed over before. */
const BATCH_BYTES = 4 * 1024 * 1024;
const TOO_SLOW = 'The node could not write records as fast as they came.';
const NO_CONNECTION =
  'The node had no connection to the master. How many records are missing is not known.';

/** What a feed works with. */
export interface FeedContext {
  readonly client: UbiiClient;
  readonly recorder: Recorder;
  /** Bit of the recording. */
  readonly target: number;
}

/** Brings the records of one recording into its file. */
export class RunningFeed {
  readonly #context: FeedContext;
  readonly #topics: RecordedTopics;
  readonly #sources = new Map<string, BatchedSource>();
  readonly #batch = new OpenBatch();
  #timer: NodeJS.Timeout | undefined;
  #lost: { readonly fromMs: number; untilMs: number; records: number } | undefined;
  #awaySinceMs: number | undefined;

  constructor(context: FeedContext, selection: RecordingSelection) {
    this.#context = context;
    this.#topics = new RecordedTopics(context.client, selection, (record) => this.#take(record));
  }

  get target(): number {
    return this.#context.target;
  }

  addSources(sources: readonly NodeRecorderSource[]): void {
    this.#topics.add(sources);
  }

  /** Records that the master could not send. [RC-61] */
  addLoss(fromMs: number, untilMs: number, records: number): void {
    const reason = 'The connection of the node could not take records as fast as they came.';
    this.#addGap(fromMs, untilMs, records, reason);
  }

  /** The connection is lost, or is there again. [RC-64] */
  handleConnection(isConnected: boolean): void {
    const nowMs = this.#context.client.masterTime.nowMs();
    if (!isConnected) this.#awaySinceMs ??= nowMs;
    else if (this.#awaySinceMs !== undefined) {
      this.#addGap(this.#awaySinceMs, nowMs, 0, NO_CONNECTION);
      this.#awaySinceMs = undefined;
    }
  }

  /** Hands over what waits: what follows comes later. */
  flush(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    if (this.#batch.count > 0) this.#context.recorder.add(this.#batch.take());
  }

  close(): void {
    this.#topics.close();
    this.flush();
  }

  #take({ topic, publisherId, bytes }: EncodedRecord): void {
    const { client, recorder, target } = this.#context;
    const timeMs = client.masterTime.nowMs();
    if (recorder.waitingBytes > MAX_WAITING_BYTES) {
      this.#lost ??= { fromMs: timeMs, untilMs: timeMs, records: 0 };
      this.#lost.untilMs = timeMs;
      this.#lost.records++;
      return;
    }
    if (this.#lost !== undefined) {
      const { fromMs, untilMs, records } = this.#lost;
      this.#lost = undefined;
      this.#addGap(fromMs, untilMs, records, TOO_SLOW);
    }
    const source = this.#sourceOf(topic, publisherId);
    this.#batch.add(source, bytes, timeMs, target);
    if (this.#batch.byteLength > BATCH_BYTES) this.flush();
    else this.#timer ??= setTimeout(() => this.flush(), BATCH_MS);
  }

  #addGap(fromMs: number, untilMs: number, records: number, reason: string): void {
    const { recorder, target } = this.#context;
    this.flush();
    recorder.addEvent(gapEvent(fromMs, untilMs, records, reason), target);
  }

  #sourceOf(topic: string, clientId: string): BatchedSource {
    const key = `${clientId} ${topic}`;
    let source = this.#sources.get(key);
    if (source === undefined)
      this.#sources.set(key, (source = { topic, clientId, batchNumber: -1, place: 0 }));
    return source;
  }
}
