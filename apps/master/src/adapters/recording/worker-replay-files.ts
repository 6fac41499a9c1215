import { ServiceError } from '@ubii/proto';
import type { RecordedSession } from '@ubii/recording';
import type { Clock } from '@ubii/timing';
import { openThread, type Calls, type Thread } from '@ubii/worker-rpc/node';

import type {
  Log,
  PlayedPart,
  PlayerCommand,
  PlayerSink,
  ReplayFacts,
  ReplayFile,
  ReplayFiles,
  ReplayPlayer,
} from '../../core/ports/index.ts';
import type { ReplayOwner, ReplayThread, ReplayThreadData } from './replay-messages.ts';

export interface WorkerReplayOptions extends ReplayThreadData {
  /** The built thread. */
  readonly workerFile: URL;
  readonly clock: Clock;
  readonly log: Log;
}

/** Heap of the thread: twice what the longest index takes. */
const HEAP_MIB = 1024;

/** Plays recordings on a thread of its own, which runs while a file is open. [RP-15] */
export class WorkerReplayFiles implements ReplayFiles {
  readonly #options: WorkerReplayOptions;
  readonly #sinks = new Map<number, PlayerSink>();
  #thread: Thread<ReplayThread> | undefined = undefined;
  #openFiles = 0;
  #lastNumber = 0;

  constructor(options: WorkerReplayOptions) {
    this.#options = options;
  }

  async open(recordingId: string): Promise<ReplayFile> {
    const file = ++this.#lastNumber;
    this.#openFiles++;
    try {
      return this.#fileOf(file, await this.#calls.open(file, recordingId));
    } catch (cause) {
      this.#release();
      throw cause;
    }
  }

  close(): Promise<void> {
    this.#sinks.clear();
    return this.#endThread();
  }

  #fileOf(file: number, facts: ReplayFacts): ReplayFile {
    const players = new Set<number>();
    let closed: Promise<void> | undefined;
    const close = async (): Promise<void> => {
      for (const player of players) this.#sinks.delete(player);
      await this.#calls.close(file).catch(() => undefined); // A thread that ended has closed it.
      this.#release();
    };
    return {
      facts,
      session: (id, timeNs): Promise<RecordedSession | undefined> =>
        this.#calls.session(file, id, timeNs),
      devices: (span) => this.#calls.devices(file, span),
      play: (part, sink) => {
        const player = ++this.#lastNumber;
        players.add(player);
        return this.#play(file, player, part, sink);
      },
      close: () => (closed ??= close()),
    };
  }

  #play(file: number, player: number, part: PlayedPart, sink: PlayerSink): ReplayPlayer {
    this.#sinks.set(player, sink);
    void this.#calls.play(file, player, part).catch(() => undefined); // `do` fails then, and says why.
    return {
      do: (command: PlayerCommand) => this.#calls.do(player, command),
      close: () => {
        this.#sinks.delete(player);
        void this.#calls.closePlayer(player).catch(() => undefined);
      },
    };
  }

  /** Starts the thread when there is none. */
  get #calls(): Calls<ReplayThread> {
    this.#thread ??= this.#startThread();
    return this.#thread.calls;
  }

  #startThread(): Thread<ReplayThread> {
    const { workerFile, folder } = this.#options;
    const workerData: ReplayThreadData = { folder };
    const owner: ReplayOwner = {
      publish: async (player, batch) => this.#sinks.get(player)?.onBatch(batch),
      showState: (player, state) => this.#sinks.get(player)?.onState(state),
    };
    return openThread(
      {
        workerFile,
        name: 'ubii replays',
        workerData,
        heapMib: HEAP_MIB,
        onEnd: (reason) => this.#fail(reason),
        lost: () => new ServiceError('unavailable', 'The replay has ended. Start it again.'),
      },
      owner,
    );
  }

  /** A file is closed. Without files, no thread is needed. */
  #release(): void {
    this.#openFiles--;
    if (this.#openFiles === 0) void this.#endThread();
  }

  async #endThread(): Promise<void> {
    const thread = this.#thread;
    this.#thread = undefined;
    await thread?.end('no file is open');
  }

  /** The replays end; the next one has another thread. */
  #fail(reason: string): void {
    this.#thread = undefined;
    this.#options.log.error('replays ended, because their thread failed', { reason });
    const lost = [...this.#sinks.values()];
    this.#sinks.clear();
    for (const sink of lost) sink.onLost(reason);
  }
}
