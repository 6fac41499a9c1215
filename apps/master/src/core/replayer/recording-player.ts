import { encodeRecordListFrame, changeRecordHead } from '@ubii/proto/wire';
import {
  Playback,
  type PlaybackState,
  type RecordedRecord,
  type RecordsReader,
} from '@ubii/recording';
import type { Clock } from '@ubii/timing';
import type { PlayedPart, PlayerCommand, PlayerSink, ReplayPlayer } from '../ports/replay-files.ts';

/** Most records of a frame: what a master publishes in one turn, about a millisecond. */
const FRAME_RECORDS = 500;
/** Bytes from which on a frame is full. */
const FRAME_BYTES = 1024 * 1024;

/** A record with its topic. */
interface NamedRecord {
  readonly topic: string;
  readonly record: Uint8Array;
}

/** A message of topic data. */
export interface Frame {
  readonly frame: Uint8Array;
  readonly records: number;
  readonly topics: ReadonlySet<string>;
}

/** Puts records into frames, in their order, so that other work has its turn between them. */
export function* splitIntoFrames(records: readonly NamedRecord[]): Generator<Frame> {
  let start = 0;
  let bytes = 0;
  for (let index = 0; index < records.length; index++) {
    bytes += records[index]!.record.length;
    const end = index + 1;
    const isFull = end - start >= FRAME_RECORDS || bytes >= FRAME_BYTES;
    if (!isFull && end < records.length) continue;
    yield frameOf(records.slice(start, end));
    start = end;
    bytes = 0;
  }
}

function frameOf(records: readonly NamedRecord[]): Frame {
  return {
    frame: encodeRecordListFrame(records.map(({ record }) => record)),
    records: records.length,
    topics: new Set(records.map(({ topic }) => topic)),
  };
}

/** Batches that may be published while further ones are played. */
const MAX_WAITING = 8;
/** Time between two reports of the position, milliseconds [RP-7]. */
const REPORT_MS = 200;

/** What a player works with. */
interface PlayerContext {
  readonly clock: Clock;
  readonly reader: RecordsReader;
  readonly part: PlayedPart;
  readonly sink: PlayerSink;
}

/** Plays topics of a recording under the names that they should have. */
export class RecordingPlayer implements ReplayPlayer {
  readonly #context: PlayerContext;
  readonly #names: ReadonlyMap<string, string>;
  readonly #playback: Playback;
  readonly #played = new Set<string>();
  #waiting = 0;
  #wake: (() => void)[] = [];
  #problem = '';
  #isClosed = false;
  #reported = '';
  #reportedMs = Number.NEGATIVE_INFINITY;

  constructor(context: PlayerContext) {
    const { clock, reader, part } = context;
    this.#context = context;
    this.#names = new Map(part.topics);
    this.#playback = new Playback({
      clock,
      reader: onlyTopics(reader, [...this.#names.keys()]),
      readAheadBytes: part.readAheadBytes,
      sink: {
        isReady: () => this.#waiting < MAX_WAITING,
        onRecords: (records) => this.#publish(records),
        onSeek: (latest) => this.#publish([...latest.values()]),
        onState: (state) => this.#report(state),
        onError: (error) => this.#fail(error),
      },
    });
  }

  async do(command: PlayerCommand): Promise<void> {
    this.#problem = '';
    await this.#carryOut(command);
    await this.#published();
  }

  close(): void {
    this.#isClosed = true;
    this.#playback.close();
    this.#wakeAll();
  }

  async #carryOut(command: PlayerCommand): Promise<void> {
    const playback = this.#playback;
    switch (command.kind) {
      case 'rate':
        return playback.setRate(command.rate);
      case 'span':
        playback.setSpan(command.span);
        return playback.setLoop(command.isLooping ? command.span : undefined);
      case 'seek':
        return playback.seek(command.positionNs);
      case 'step':
        return playback.step(command.moments);
      case 'play':
        return playback.play();
      case 'pause':
        return playback.pause();
    }
  }

  /** Resolves when nothing waits to be published. */
  async #published(): Promise<void> {
    while (this.#waiting > 0 && !this.#isClosed) {
      await new Promise<void>((resolve) => this.#wake.push(resolve));
    }
  }

  #publish(records: readonly RecordedRecord[]): void {
    const { clock, part, sink } = this.#context;
    const timeMs = part.keepsTimestamps ? undefined : clock.nowMs();
    const named = records.map(({ topic, record }) => {
      const played = this.#names.get(topic)!;
      const change = { topic: played === topic ? undefined : played, timeMs };
      return {
        topic: played,
        record: changeRecordHead(record, { ...change, clientId: part.clientId }),
      };
    });
    for (const { frame, records: count, topics } of splitIntoFrames(named)) {
      const newTopics = [...topics].filter((topic) => !this.#played.has(topic));
      for (const topic of newTopics) this.#played.add(topic);
      this.#waiting++;
      void sink.onBatch({ frame, records: count, newTopics }).finally(() => {
        this.#waiting--;
        this.#wakeAll();
      });
    }
  }

  #wakeAll(): void {
    const waiting = this.#wake;
    this.#wake = [];
    for (const wake of waiting) wake();
  }

  #fail(error: unknown): void {
    const reason = error instanceof Error ? error.message : String(error);
    this.#problem = `The recording could not be read: ${reason} Play it again to try again.`;
    this.#report(this.#playback.state);
  }

  #report({ status, positionNs, isBuffering }: PlaybackState): void {
    const { clock, sink } = this.#context;
    const nowMs = clock.monotonicMs();
    const words = `${status} ${this.#problem}`;
    const isMoving = status === 'playing' || isBuffering;
    const isDue = !isMoving || nowMs - this.#reportedMs >= REPORT_MS;
    if (this.#isClosed || (words === this.#reported && !isDue)) return;
    this.#reported = words;
    this.#reportedMs = nowMs;
    sink.onState({ status, positionNs, problem: this.#problem });
  }
}

function onlyTopics(reader: RecordsReader, topics: readonly string[]): RecordsReader {
  return {
    summary: reader.summary,
    records: (query) => reader.records({ topics, ...query }),
    latestAt: (timeNs) => reader.latestAt(timeNs, topics),
  };
}
