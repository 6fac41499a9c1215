import { ServiceError } from '@ubii/proto';
import {
  devicesInSpan,
  RecordingError,
  RecordingReader,
  type RecordedDevice,
  type RecordedSession,
  type Span,
} from '@ubii/recording';
import type { Clock } from '@ubii/timing';
import type {
  PlayedPart,
  PlayerSink,
  ReplayFacts,
  ReplayFile,
  ReplayFiles,
  ReplayPlayer,
} from '../ports/replay-files.ts';
import type { OpenFile, RecordingFolder } from '@ubii/recording/recorder';
import { RecordingPlayer } from './recording-player.ts';

/** Maximum devices of a span for replays: as many as a master may have. */
const MAX_DEVICES = 20_000;

/** Where recordings are, and the time. */
export interface FolderReplaysContext {
  readonly folder: Pick<RecordingFolder, 'open'>;
  readonly clock: Clock;
}

/** Plays recordings of a folder. The master runs it on a thread of its own. */
export class FolderReplays implements ReplayFiles {
  readonly #context: FolderReplaysContext;
  readonly #open = new Set<FolderReplay>();

  constructor(context: FolderReplaysContext) {
    this.#context = context;
  }

  async open(recordingId: string): Promise<ReplayFile> {
    const { folder, clock } = this.#context;
    const file = await folder.open(recordingId).catch((cause: unknown) => {
      throw notReadable(recordingId, cause);
    });
    try {
      const reader = await RecordingReader.open(file);
      const onClosed = () => this.#open.delete(replay);
      const replay = new FolderReplay(recordingId, { clock, file, reader, onClosed });
      this.#open.add(replay);
      return replay;
    } catch (cause) {
      await file.close();
      throw notReadable(recordingId, cause);
    }
  }

  async close(): Promise<void> {
    await Promise.all([...this.#open].map((replay) => replay.close()));
  }
}

interface OpenedRecording {
  readonly clock: Clock;
  readonly file: OpenFile;
  readonly reader: RecordingReader;
  readonly onClosed: () => void;
}

class FolderReplay implements ReplayFile {
  readonly #id: string;
  readonly #opened: OpenedRecording;
  readonly #players = new Set<RecordingPlayer>();
  #closed: Promise<void> | undefined = undefined;

  constructor(id: string, opened: OpenedRecording) {
    this.#id = id;
    this.#opened = opened;
  }

  get facts(): ReplayFacts {
    const { startNs, endNs, topics } = this.#opened.reader.summary;
    return { startNs, endNs, topics };
  }

  session(id: string, timeNs: bigint): Promise<RecordedSession | undefined> {
    return this.#read(async (reader) => {
      for (const momentNs of [timeNs, reader.summary.endNs]) {
        const session = (await reader.sessionsAt(momentNs)).get(id);
        if (session !== undefined) return session;
      }
      return undefined;
    });
  }

  devices(span: Span): Promise<readonly RecordedDevice[]> {
    return this.#read(async (reader) =>
      devicesInSpan(await reader.devices(), span).slice(0, MAX_DEVICES),
    );
  }

  play(part: PlayedPart, sink: PlayerSink): ReplayPlayer {
    const { clock, reader } = this.#opened;
    const player = new RecordingPlayer({ clock, reader, part, sink });
    this.#players.add(player);
    return player;
  }

  close(): Promise<void> {
    this.#closed ??= this.#close();
    return this.#closed;
  }

  /** @throws ServiceError when the file is damaged */
  async #read<T>(work: (reader: RecordingReader) => Promise<T>): Promise<T> {
    try {
      return await work(this.#opened.reader);
    } catch (cause) {
      throw cause instanceof RecordingError ? notReadable(this.#id, cause) : cause;
    }
  }

  async #close(): Promise<void> {
    for (const player of this.#players) player.close();
    this.#opened.onClosed();
    await this.#opened.file.close();
  }
}

function notReadable(id: string, cause: unknown): ServiceError {
  const reason = cause instanceof Error ? cause.message : String(cause);
  return new ServiceError(
    'failed_precondition',
    `The recording "${id}" cannot be read: ${reason}`,
    { cause },
  );
}
