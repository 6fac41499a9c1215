import type { Cancel, Clock } from '@ubii/timing';
import type { RecordsReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import { RecordFeed } from './record-feed.ts';

/** A span of a recording, nanoseconds since the Unix epoch. */
export interface Span {
  readonly fromNs: bigint;
  readonly untilNs: bigint;
}

/** What a playback does. */
export interface PlaybackState {
  readonly status: 'paused' | 'playing' | 'ended';
  readonly positionNs: bigint;
  /** 0.1 to 10. */
  readonly rate: number;
  readonly loop: Span | undefined;
  /** What is played once when there is no loop; undefined for all. */
  readonly span: Span | undefined;
  /** Waits for the source, or for the sink. */
  readonly isBuffering: boolean;
}

/** Where records go. */
export interface PlaybackSink {
  /** Records that are due, in order. */
  onRecords(records: readonly RecordedRecord[]): void;
  /** The playhead jumped: the last record of each topic at the new moment. Topics that are not in it have no value there. */
  onSeek(latest: ReadonlyMap<string, RecordedRecord>, positionNs: bigint): void;
  /** Status, rate, loop, buffering or position changed. While playing, position changes with each tick. */
  onState(state: PlaybackState): void;
  /** The source failed; playback is paused. */
  onError(error: unknown): void;
  /** Whether it can take records now; playback waits until it can. @default always */
  isReady?(): boolean;
}

/** Options of a playback. */
export interface PlaybackOptions {
  readonly clock: Clock;
  readonly reader: RecordsReader;
  readonly sink: PlaybackSink;
  /** Time between two ticks, milliseconds. @default 16 */
  readonly tickMs?: number;
  /** Bytes of records that are read ahead. @default 16 MiB */
  readonly readAheadBytes?: number;
}

const MIN_RATE = 0.1;
const MAX_RATE = 10;
const NS_PER_MS = 1_000_000;

/** Plays a recording. Begins paused at the start, and has emitted nothing then: call `seek` to get the first values. */
export class Playback {
  readonly #clock: Clock;
  readonly #reader: RecordsReader;
  readonly #sink: PlaybackSink;
  readonly #tickMs: number;
  readonly #readAheadBytes: number | undefined;
  #state: PlaybackState;
  /** Records up to this time were emitted, or are in the values of a seek. */
  #emittedNs: bigint;
  /** Monotonic time of the last tick. */
  #tickedAtMs = 0;
  #cancelTicks: Cancel = () => undefined;
  #feed: RecordFeed | undefined;
  #wantedNs: bigint | undefined;
  #seeking: Promise<void> | undefined;
  #isClosed = false;

  constructor({ clock, reader, sink, tickMs = 16, readAheadBytes }: PlaybackOptions) {
    this.#clock = clock;
    this.#reader = reader;
    this.#sink = sink;
    this.#tickMs = tickMs;
    this.#readAheadBytes = readAheadBytes;
    const { startNs } = reader.summary;
    this.#state = {
      status: 'paused',
      positionNs: startNs,
      rate: 1,
      loop: undefined,
      span: undefined,
      isBuffering: false,
    };
    this.#emittedNs = startNs - 1n;
  }

  get state(): PlaybackState {
    return this.#state;
  }

  /** Goes on; from the start (of the loop) when the end was reached. */
  play(): void {
    const { status, positionNs } = this.#state;
    if (status === 'playing' || this.#isClosed) return;
    this.#change({ status: 'playing' });
    this.#tickedAtMs = this.#clock.monotonicMs();
    this.#cancelTicks = this.#clock.every(this.#tickMs, () => this.#tick());
    const { fromNs, untilNs } = this.#span();
    if (positionNs < fromNs || positionNs >= untilNs) void this.seek(fromNs);
    else if (this.#seeking === undefined) this.#openFeed();
  }

  pause(): void {
    if (this.#state.status !== 'playing') return;
    this.#halt('paused');
  }

  /** @param rate is limited to 0.1 … 10 */
  setRate(rate: number): void {
    this.#tick();
    this.#change({ rate: Math.min(Math.max(rate, MIN_RATE), MAX_RATE) });
  }

  /** Plays this span again and again; undefined ends that. */
  setLoop(loop: Span | undefined): void {
    this.#setSpans({ loop });
  }

  /** Plays no more than this span; undefined ends that. A loop counts more. */
  setSpan(span: Span | undefined): void {
    this.#setSpans({ span });
  }

  #setSpans(change: Pick<Partial<PlaybackState>, 'loop' | 'span'>): void {
    this.#change(change);
    if (this.#state.status !== 'playing') return;
    const { fromNs, untilNs } = this.#span();
    const { positionNs } = this.#state;
    if (positionNs < fromNs || positionNs >= untilNs) void this.seek(fromNs);
    else if (this.#seeking === undefined) this.#openFeed();
  }

  /** Jumps and emits the last value of every topic. While one seek runs, only the newest of further ones is kept. */
  seek(positionNs: bigint): Promise<void> {
    const { startNs, endNs } = this.#reader.summary;
    this.#wantedNs = clamp(positionNs, startNs, endNs);
    this.#seeking ??= this.#runSeeks();
    return this.#seeking;
  }

  /** Pauses and jumps to the next or the previous moment at which the topic has a record; does nothing when there is none. */
  async stepRecord(topic: string, direction: 1 | -1): Promise<void> {
    this.pause();
    await this.#seeking;
    const span =
      direction === 1
        ? { fromNs: this.#emittedNs + 1n }
        : { untilNs: this.#state.positionNs - 1n, isReverse: true };
    for await (const { logTimeNs } of this.#reader.records({ topics: [topic], ...span })) {
      return this.seek(logTimeNs);
    }
  }

  /**
   * Pauses, and goes on by moments that have records, or with a negative number back. Going on emits these records; going
   * back, the last value of every topic.
   */
  async step(moments: number): Promise<void> {
    this.pause();
    await this.#seeking;
    try {
      if (moments > 0) await this.#stepOn(moments);
      else if (moments < 0) await this.#stepBack(-moments);
    } catch (error) {
      this.#fail(error);
    }
  }

  /** Pauses and jumps by a time. @param deltaMs may be negative */
  async stepTime(deltaMs: number): Promise<void> {
    this.pause();
    await this.#seeking;
    await this.seek(this.#state.positionNs + BigInt(Math.round(deltaMs * NS_PER_MS)));
  }

  /** Ends timers and reading. */
  close(): void {
    this.#isClosed = true;
    this.#cancelTicks();
    this.#feed?.close();
  }

  async #stepOn(moments: number): Promise<void> {
    const records: RecordedRecord[] = [];
    let passed = 0;
    const { untilNs } = this.#span();
    const fromNs = this.#emittedNs + 1n;
    for await (const record of this.#reader.records({ fromNs, untilNs })) {
      if (record.logTimeNs !== records.at(-1)?.logTimeNs && ++passed > moments) break;
      records.push(record);
    }
    const positionNs = records.at(-1)?.logTimeNs;
    const isCurrent = this.#emittedNs + 1n === fromNs && this.#seeking === undefined;
    if (positionNs === undefined || !isCurrent || this.#state.status === 'playing') return;
    this.#emittedNs = positionNs;
    this.#sink.onRecords(records);
    this.#change({ positionNs });
  }

  async #stepBack(moments: number): Promise<void> {
    let passed = 0;
    let momentNs: bigint | undefined;
    const query = { untilNs: this.#state.positionNs - 1n, isReverse: true };
    for await (const { logTimeNs } of this.#reader.records(query)) {
      if (logTimeNs === momentNs) continue;
      if (++passed > moments) break;
      momentNs = logTimeNs;
    }
    if (momentNs !== undefined) await this.seek(momentNs);
  }

  /** What is played: the loop, the span, or all. */
  #span(): Span {
    const { startNs, endNs } = this.#reader.summary;
    const { loop, span } = this.#state;
    return loop ?? span ?? { fromNs: startNs, untilNs: endNs };
  }

  #tick(): void {
    const nowMs = this.#clock.monotonicMs();
    const elapsedMs = nowMs - this.#tickedAtMs;
    this.#tickedAtMs = nowMs;
    if (this.#feed === undefined || this.#state.status !== 'playing') return;
    if (this.#sink.isReady?.() === false) return this.#change({ isBuffering: true });
    const { positionNs, rate, loop } = this.#state;
    const { fromNs, untilNs } = this.#span();
    const wantedNs = positionNs + BigInt(Math.round(elapsedMs * rate * NS_PER_MS));
    const targetNs = wantedNs < untilNs ? wantedNs : untilNs;
    const { records, reachedNs } = this.#feed.take(targetNs);
    this.#emittedNs = reachedNs;
    if (records.length > 0) this.#sink.onRecords(records);
    const reached = reachedNs > positionNs ? reachedNs : positionNs;
    this.#change({ positionNs: reached, isBuffering: reachedNs < targetNs });
    if (reachedNs < untilNs) return;
    if (loop === undefined) this.#halt('ended');
    else void this.seek(fromNs);
  }

  async #runSeeks(): Promise<void> {
    this.#feed?.close();
    this.#feed = undefined;
    while (this.#wantedNs !== undefined && !this.#isClosed) {
      const positionNs = this.#wantedNs;
      this.#wantedNs = undefined;
      const isEnded = this.#state.status === 'ended';
      this.#change({ positionNs, ...(isEnded && { status: 'paused' }) });
      try {
        const latest = await this.#reader.latestAt(positionNs);
        if (this.#isClosed) return;
        this.#emittedNs = positionNs;
        this.#sink.onSeek(latest, positionNs);
      } catch (error) {
        this.#fail(error);
      }
    }
    this.#seeking = undefined;
    if (this.#state.status === 'playing') this.#openFeed();
  }

  #openFeed(): void {
    this.#feed?.close();
    this.#tickedAtMs = this.#clock.monotonicMs();
    const { untilNs } = this.#span();
    this.#feed = new RecordFeed({
      reader: this.#reader,
      fromNs: this.#emittedNs + 1n,
      untilNs,
      maxBytes: this.#readAheadBytes,
      onError: (error) => this.#fail(error),
    });
  }

  #halt(status: 'paused' | 'ended'): void {
    this.#cancelTicks();
    this.#feed?.close();
    this.#feed = undefined;
    this.#change({ status, isBuffering: false });
  }

  #fail(error: unknown): void {
    if (this.#isClosed) return;
    this.#halt('paused');
    this.#sink.onError(error);
  }

  #change(change: Partial<PlaybackState>): void {
    this.#state = { ...this.#state, ...change };
    this.#sink.onState(this.#state);
  }
}

function clamp(value: bigint, min: bigint, max: bigint): bigint {
  if (value < min) return min;
  return value > max ? max : value;
}
