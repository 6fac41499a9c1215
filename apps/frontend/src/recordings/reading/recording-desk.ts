import {
  Playback,
  type PlaybackState,
  type RecordedRecord,
  type RecordingEvent,
  type RecordingReader,
} from '@ubii/recording';
import type { Clock } from '@ubii/timing';
import { openedRecording } from './opened-recording.ts';
import { readFrame } from './frame-reader.ts';
import type { PlayedValue, RecordingCommand, RecordingReport } from './recording-messages.ts';
import type { TileRequest, TileViewer } from '../timeline/tile-store.ts';
import { TimeBase } from './recording-time-base.ts';
import { sessionsNear } from './sessions-near.ts';
import type { ReadTurns } from './read-turns.ts';
import { readSurvey } from './survey-reader.ts';
import { readTiles } from './tile-reader.ts';

/** Says something to the page. @param transfer what it may take over */
export type Tell = (report: RecordingReport, transfer?: Transferable[]) => void;

/** Everything but opening. */
export type DeskCommand = Exclude<RecordingCommand, { kind: 'open' | 'reopen' }>;

/** Parts of the recording whose records are counted: each has some pixels on a wide screen. */
const ACTIVITY_PARTS = 512;

/** Answers what a page asks of one recording. */
export class RecordingDesk {
  readonly #reader: RecordingReader;
  readonly #tell: Tell;
  readonly #base: TimeBase;
  readonly #playback: Playback;
  readonly #turns: ReadTurns;
  readonly #tilesAsked = new Map<TileViewer, number>();
  #sessions: readonly RecordingEvent<'session'>[] = [];
  #sessionsTold = '';

  constructor(reader: RecordingReader, clock: Clock, turns: ReadTurns, tell: Tell) {
    this.#reader = reader;
    this.#turns = turns;
    this.#tell = tell;
    this.#base = new TimeBase(reader.summary.startNs);
    this.#playback = new Playback({
      clock,
      reader,
      sink: {
        onRecords: (records) => this.#tellValues(newestOf(records), false),
        onSeek: (latest) => this.#tellValues(latest, true),
        onState: (state) => this.#tellState(state),
        onError: (error) => tell({ kind: 'failed', message: sentenceOf(error) }),
      },
    });
  }

  get state(): PlaybackState {
    return this.#playback.state;
  }

  /** Tells what the recording is and, bit by bit, what is in it. */
  async begin(): Promise<void> {
    this.#tellOpened();
    this.#sessions = await this.#reader.sessions();
    this.#tellState(this.#playback.state);
    await this.#playback.seek(this.#reader.summary.startNs);
    this.#tell({ kind: 'activity', activity: this.#reader.activity(ACTIVITY_PARTS) });
    await this.#turns.run('survey', (turn) =>
      readSurvey(
        this.#reader,
        turn,
        () => this.#turns.nowMs(),
        (survey) => this.#tell({ kind: 'survey', survey }),
      ),
    );
    await this.#tellClocks();
  }

  /** Goes on where another desk was with the same records. */
  async resume({ positionNs, rate, loop, status }: PlaybackState): Promise<void> {
    this.#tellOpened();
    this.#sessions = await this.#reader.sessions();
    this.#playback.setRate(rate);
    this.#playback.setLoop(loop);
    await this.#playback.seek(positionNs);
    if (status === 'playing') this.#playback.play();
  }

  close(): void {
    this.#playback.close();
  }

  async handle(command: DeskCommand): Promise<void> {
    switch (command.kind) {
      case 'tiles':
        return this.#readTiles(command.request);
      case 'frame': {
        const { topic, timeMs } = command;
        const picture = await this.#turns.run('frame', () =>
          readFrame(this.#reader, topic, timeMs),
        );
        this.#tell({ kind: 'frame', topic, timeMs, picture }, picture ? [picture] : []);
        return;
      }
      case 'play':
        return this.#playback.play();
      case 'pause':
        return this.#playback.pause();
      case 'rate':
        return this.#playback.setRate(command.rate);
      case 'loop': {
        const { loop } = command;
        return this.#playback.setLoop(
          loop && { fromNs: this.#base.toNs(loop.fromMs), untilNs: this.#base.toNs(loop.untilMs) },
        );
      }
      case 'seek':
        return this.#first(() => this.#playback.seek(this.#base.toNs(command.timeMs)));
      case 'stepRecord':
        return this.#first(() => this.#playback.stepRecord(command.topic, command.direction));
      case 'stepTime':
        return this.#first(() => this.#playback.stepTime(command.deltaMs));
    }
  }

  /** Moves the playhead before anything else is read. */
  #first(move: () => Promise<void>): Promise<void> {
    return this.#turns.run('seek', move);
  }

  /** A request takes the place of the last one of the same view. */
  #readTiles(request: TileRequest): Promise<void> {
    const { viewer, level } = request;
    const asked = (this.#tilesAsked.get(viewer) ?? 0) + 1;
    this.#tilesAsked.set(viewer, asked);
    const isWanted = (): boolean => asked === this.#tilesAsked.get(viewer);
    return this.#turns.run('tile', (turn) =>
      readTiles(this.#reader, request, { turn, isWanted }, (topic, index, tile) =>
        this.#tell({ kind: 'tile', topic, level, index, tile }),
      ),
    );
  }

  #tellOpened(): void {
    this.#tell({ kind: 'opened', recording: openedRecording(this.#reader.summary) });
  }

  /** Last, because clocks are in many small parts of a file. */
  async #tellClocks(): Promise<void> {
    const clocks = await this.#reader.clocks();
    const errorMs = clocks.reduce((most, { value }) => Math.max(most, value.errorMs), -Infinity);
    if (errorMs >= 0) this.#tell({ kind: 'clocks', errorMs });
  }

  #tellValues(records: ReadonlyMap<string, RecordedRecord>, isAll: boolean): void {
    const values = Array.from(records.values(), ({ topic, record, logTimeNs }): PlayedValue => {
      return { topic, timeMs: this.#base.toMs(logTimeNs), record: record.slice() };
    });
    this.#tell(
      { kind: 'values', isAll, values },
      values.map(({ record }) => record.buffer),
    );
  }

  #tellState({ status, positionNs, rate, loop, isBuffering }: PlaybackState): void {
    const timeMs = this.#base.toMs(positionNs);
    const placedLoop = loop && {
      fromMs: this.#base.toMs(loop.fromNs),
      untilMs: this.#base.toMs(loop.untilNs),
    };
    const player = { status, timeMs, rate, loop: placedLoop, isBuffering };
    this.#tell({ kind: 'player', player });
    this.#tellSessions(timeMs);
  }

  #tellSessions(timeMs: number): void {
    const sessions = sessionsNear(this.#sessions, timeMs, this.#base);
    const summary = sessions.map(({ id, presence, sinceMs }) => [id, presence, sinceMs]).join(' ');
    if (summary === this.#sessionsTold) return;
    this.#sessionsTold = summary;
    this.#tell({ kind: 'sessions', sessions });
  }
}

function newestOf(records: readonly RecordedRecord[]): Map<string, RecordedRecord> {
  return new Map(records.map((record) => [record.topic, record]));
}

/** An error as a sentence for the page. */
export function sentenceOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
