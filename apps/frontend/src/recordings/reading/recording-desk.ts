import {
  Playback,
  type PlaybackState,
  type RecordedRecord,
  type RecordingEvent,
  type RecordingReader,
} from '@ubii/recording';
import type { Clock } from '@ubii/timing';
import { transfer } from '@ubii/worker-rpc/browser';
import { openedRecording } from './opened-recording.ts';
import { readFrame } from './frame-reader.ts';
import type { PlayedValue, RecordingPage, RecordingWorker } from './recording-messages.ts';
import type { Span } from '../timeline/span.ts';
import type { TileRequest, TileViewer } from '../timeline/tile-store.ts';
import { TimeBase } from './recording-time-base.ts';
import { sessionsNear } from './sessions-near.ts';
import type { ReadTurns } from './read-turns.ts';
import { readSurvey } from './survey-reader.ts';
import { readTiles } from './tile-reader.ts';

/** Parts of the recording whose records are counted: each has some pixels on a wide screen. */
const ACTIVITY_PARTS = 512;

/** Answers what a page asks of one recording. */
export class RecordingDesk implements Omit<RecordingWorker, 'open' | 'reopen'> {
  readonly #reader: RecordingReader;
  readonly #page: RecordingPage;
  readonly #base: TimeBase;
  readonly #playback: Playback;
  readonly #turns: ReadTurns;
  readonly #tilesAsked = new Map<TileViewer, number>();
  #sessions: readonly RecordingEvent<'session'>[] = [];
  #shownSessions = '';

  constructor(reader: RecordingReader, clock: Clock, turns: ReadTurns, page: RecordingPage) {
    this.#reader = reader;
    this.#turns = turns;
    this.#page = page;
    this.#base = new TimeBase(reader.summary.startNs);
    this.#playback = new Playback({
      clock,
      reader,
      sink: {
        onRecords: (records) => this.#showValues(newestOf(records), false),
        onSeek: (latest) => this.#showValues(latest, true),
        onState: (state) => this.#showState(state),
        onError: (error) => page.showFailure(sentenceOf(error)),
      },
    });
  }

  get state(): PlaybackState {
    return this.#playback.state;
  }

  /** Tells what the recording is and, bit by bit, what is in it. */
  async begin(): Promise<void> {
    this.#showOpened();
    this.#sessions = await this.#reader.sessions();
    this.#showState(this.#playback.state);
    await this.#playback.seek(this.#reader.summary.startNs);
    this.#page.showActivity(this.#reader.activity(ACTIVITY_PARTS));
    await this.#turns.run('survey', (turn) =>
      readSurvey(
        this.#reader,
        turn,
        () => this.#turns.nowMs(),
        (survey) => this.#page.showSurvey(survey),
      ),
    );
    await this.#showClocks();
  }

  /** Goes on where another desk was with the same records. */
  async resume({ positionNs, rate, loop, status }: PlaybackState): Promise<void> {
    this.#showOpened();
    this.#sessions = await this.#reader.sessions();
    this.#playback.setRate(rate);
    this.#playback.setLoop(loop);
    await this.#playback.seek(positionNs);
    if (status === 'playing') this.#playback.play();
  }

  close(): void {
    this.#playback.close();
  }

  /** A request takes the place of the last one of the same view. */
  readTiles(request: TileRequest): Promise<void> {
    const { viewer, level } = request;
    const asked = (this.#tilesAsked.get(viewer) ?? 0) + 1;
    this.#tilesAsked.set(viewer, asked);
    const isWanted = (): boolean => asked === this.#tilesAsked.get(viewer);
    return this.#turns.run('tile', (turn) =>
      readTiles(this.#reader, request, { turn, isWanted }, (topic, index, tile) =>
        this.#page.showTile(topic, level, index, tile),
      ),
    );
  }

  async readFrame(topic: string, timeMs: number): Promise<ImageBitmap | undefined> {
    const picture = await this.#turns.run('frame', () => readFrame(this.#reader, topic, timeMs));
    return picture && transfer(picture);
  }

  async play(): Promise<void> {
    this.#playback.play();
  }

  async pause(): Promise<void> {
    this.#playback.pause();
  }

  async setRate(rate: number): Promise<void> {
    this.#playback.setRate(rate);
  }

  async setLoop(loop: Span | undefined): Promise<void> {
    this.#playback.setLoop(
      loop && { fromNs: this.#base.toNs(loop.fromMs), untilNs: this.#base.toNs(loop.untilMs) },
    );
  }

  seek(timeMs: number): Promise<void> {
    return this.#first(() => this.#playback.seek(this.#base.toNs(timeMs)));
  }

  stepRecord(topic: string, direction: 1 | -1): Promise<void> {
    return this.#first(() => this.#playback.stepRecord(topic, direction));
  }

  stepTime(deltaMs: number): Promise<void> {
    return this.#first(() => this.#playback.stepTime(deltaMs));
  }

  /** Moves the playhead before anything else is read. */
  #first(move: () => Promise<void>): Promise<void> {
    return this.#turns.run('seek', move);
  }

  #showOpened(): void {
    this.#page.showOpened(openedRecording(this.#reader.summary));
  }

  /** Last, because clocks are in many small parts of a file. */
  async #showClocks(): Promise<void> {
    const clocks = await this.#reader.clocks();
    const errorMs = clocks.reduce((most, { value }) => Math.max(most, value.errorMs), -Infinity);
    if (errorMs >= 0) this.#page.showClocks(errorMs);
  }

  #showValues(records: ReadonlyMap<string, RecordedRecord>, isAll: boolean): void {
    const values = Array.from(records.values(), ({ topic, record, logTimeNs }): PlayedValue => {
      return { topic, timeMs: this.#base.toMs(logTimeNs), record: record.slice() };
    });
    const buffers = values.map(({ record }) => record.buffer);
    this.#page.showValues(transfer(values, buffers), isAll);
  }

  #showState({ status, positionNs, rate, loop, isBuffering }: PlaybackState): void {
    const timeMs = this.#base.toMs(positionNs);
    const placedLoop = loop && {
      fromMs: this.#base.toMs(loop.fromNs),
      untilMs: this.#base.toMs(loop.untilNs),
    };
    this.#page.showPlayer({ status, timeMs, rate, loop: placedLoop, isBuffering });
    this.#showSessions(timeMs);
  }

  #showSessions(timeMs: number): void {
    const sessions = sessionsNear(this.#sessions, timeMs, this.#base);
    const summary = sessions.map(({ id, presence, sinceMs }) => [id, presence, sinceMs]).join(' ');
    if (summary === this.#shownSessions) return;
    this.#shownSessions = summary;
    this.#page.showSessions(sessions);
  }
}

function newestOf(records: readonly RecordedRecord[]): Map<string, RecordedRecord> {
  return new Map(records.map((record) => [record.topic, record]));
}

/** An error as a sentence for the page. */
function sentenceOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
