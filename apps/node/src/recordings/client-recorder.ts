import type { UbiiClient } from '@ubii/client-web/node';
import type { EncodedRecord } from '@ubii/client-web/node';
import { describeRecord, type RecordedRecord, type RecordingWriter } from '@ubii/recording';
import { nsOf } from '@ubii/recording/recorder';
import { followFacts, presentFacts } from '../recorder/recorded-facts.ts';

/** What is collected is written after this time: an end without warning loses no more. Milliseconds. */
const FLUSH_MS = 1000;

/** Which records a recorder takes, and when it ends by itself. */
export interface RecorderChoice {
  /** Subscriptions: topics and globs. */
  readonly patterns: readonly string[];
  isChosen(topic: string): boolean;
  readonly withImages: boolean;
  /** Longest duration, milliseconds; Infinity: none. */
  readonly maxMs: number;
  /** Largest file, bytes; Infinity: none. */
  readonly maxBytes: number;
  /** Called about once a second, when everything that came is in the file. */
  onProgress(): void;
}

/** Writes what a client receives into a recording. */
export class ClientRecorder {
  readonly #client: UbiiClient;
  readonly #writer: RecordingWriter;
  readonly #choice: RecorderChoice;
  readonly #abort = new AbortController();
  #startNs: bigint | undefined;
  #lastNs = 0n;

  constructor(client: UbiiClient, writer: RecordingWriter, choice: RecorderChoice) {
    this.#client = client;
    this.#writer = writer;
    this.#choice = choice;
  }

  /** From the first record to the last, nanoseconds. */
  get lengthNs(): bigint {
    return this.#startNs === undefined ? 0n : this.#lastNs - this.#startNs;
  }

  /**
   * Records until `signal` is aborted or a limit is reached.
   *
   * @returns why it ended, as a sentence
   * @throws the error of the file
   */
  async run(signal: AbortSignal): Promise<string> {
    for (const event of await presentFacts(this.#client)) this.#writer.addEvent(event);
    const { patterns, maxMs } = this.#choice;
    const ends = patterns.map((glob) =>
      this.#client.subscribeEncoded(
        { glob },
        { onRecord: (record) => this.#take(record), onGone: () => undefined },
      ),
    );
    ends.push(followFacts(this.#client, (event) => this.#writer.addEvent(event)));
    const timer = setInterval(() => void this.#flush(), FLUSH_MS);
    const limit = Number.isFinite(maxMs)
      ? setTimeout(() => this.#abort.abort('The time is over'), maxMs)
      : undefined;
    try {
      await aborted(AbortSignal.any([signal, this.#abort.signal]));
    } finally {
      clearInterval(timer);
      clearTimeout(limit);
      for (const end of ends) end();
    }
    const { reason } = this.#abort.signal as { reason: unknown };
    if (reason instanceof Error) throw reason;
    return typeof reason === 'string' ? reason : 'Stopped';
  }

  #take({ topic, bytes, publisherId }: EncodedRecord): void {
    if (this.#abort.signal.aborted || !this.#choice.isChosen(topic)) return;
    const { format, timestampMs } = describeRecord(bytes);
    if (!this.#choice.withImages && (format === 'image2D' || format === 'image2DList')) return;
    const logTimeNs = this.#nowNs();
    this.#startNs ??= logTimeNs;
    this.#lastNs = logTimeNs;
    const publishTimeNs = timestampMs === undefined ? logTimeNs : nsOf(timestampMs);
    this.#add({ topic, clientId: publisherId, record: bytes, logTimeNs, publishTimeNs });
    if (this.#writer.statistics.bytes >= this.#choice.maxBytes) {
      this.#abort.abort('The file has its largest size');
    }
  }

  #add(record: RecordedRecord): void {
    try {
      this.#writer.addRecord(record)?.catch((error: unknown) => this.#fail(error));
    } catch (error) {
      this.#fail(error);
    }
  }

  async #flush(): Promise<void> {
    try {
      await this.#writer.flush();
      this.#choice.onProgress();
    } catch (error) {
      this.#fail(error);
    }
  }

  #fail(error: unknown): void {
    this.#abort.abort(error instanceof Error ? error : new Error(String(error)));
  }

  #nowNs(): bigint {
    return nsOf(this.#client.masterTime.nowMs());
  }
}

function aborted(signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    if (signal.aborted) resolve();
    else signal.addEventListener('abort', () => resolve(), { once: true });
  });
}
