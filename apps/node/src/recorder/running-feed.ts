import type { EncodedRecord, UbiiClient } from '@ubii/client-web/node';
import type { NodeRecorderSource, RecordingSelection } from '@ubii/proto';
import { gapEvent, type ChannelSource, type Recorder } from '@ubii/recording/recorder';
import { RecordedTopics } from './recorded-topics.ts';

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
  readonly #sources = new Map<string, ChannelSource>();
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
    this.#context.recorder.flush();
  }

  close(): void {
    this.#topics.close();
    this.flush();
  }

  #take({ topic, publisherId, bytes }: EncodedRecord): void {
    const { client, recorder, target } = this.#context;
    const timeMs = client.masterTime.nowMs();
    recorder.add(this.#sourceOf(topic, publisherId), bytes, timeMs, target);
  }

  #addGap(fromMs: number, untilMs: number, records: number, reason: string): void {
    const { recorder, target } = this.#context;
    recorder.addEvent(gapEvent(fromMs, untilMs, records, reason), target);
  }

  #sourceOf(topic: string, clientId: string): ChannelSource {
    const key = `${clientId} ${topic}`;
    let source = this.#sources.get(key);
    if (source === undefined)
      this.#sources.set(key, (source = { topic, clientId, channel: undefined }));
    return source;
  }
}
