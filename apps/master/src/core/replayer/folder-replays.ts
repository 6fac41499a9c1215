import { ServiceError } from '@ubii/proto';
import {
  devicesInSpan,
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

/** Devices of a span that replays are told of: as many as a master may have. */
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
      const replay = new FolderReplay(clock, file, reader, () => this.#open.delete(replay));
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

class FolderReplay implements ReplayFile {
  readonly #clock: Clock;
  readonly #file: OpenFile;
  readonly #reader: RecordingReader;
  readonly #players = new Set<RecordingPlayer>();
  readonly #onClosed: () => void;
  #closed: Promise<void> | undefined = undefined;

  constructor(clock: Clock, file: OpenFile, reader: RecordingReader, onClosed: () => void) {
    this.#clock = clock;
    this.#file = file;
    this.#reader = reader;
    this.#onClosed = onClosed;
  }

  get facts(): ReplayFacts {
    const { startNs, endNs, topics } = this.#reader.summary;
    return { startNs, endNs, topics };
  }

  async session(id: string, timeNs: bigint): Promise<RecordedSession | undefined> {
    const { endNs } = this.#reader.summary;
    for (const momentNs of [timeNs, endNs]) {
      const session = (await this.#reader.sessionsAt(momentNs)).get(id);
      if (session !== undefined) return session;
    }
    return undefined;
  }

  async devices(span: Span): Promise<readonly RecordedDevice[]> {
    return devicesInSpan(await this.#reader.devices(), span).slice(0, MAX_DEVICES);
  }

  play(part: PlayedPart, sink: PlayerSink): ReplayPlayer {
    const player = new RecordingPlayer({ clock: this.#clock, reader: this.#reader, part, sink });
    this.#players.add(player);
    return player;
  }

  close(): Promise<void> {
    this.#closed ??= this.#close();
    return this.#closed;
  }

  async #close(): Promise<void> {
    for (const player of this.#players) player.close();
    this.#onClosed();
    await this.#file.close();
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
