import type { Worker } from 'node:worker_threads';
import { ServiceError } from '@ubii/proto';
import type { RecordedSession } from '@ubii/recording';
import type { Clock } from '@ubii/timing';

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
import { openThread } from '@ubii/recording/thread';
import type {
  FromReplayThread,
  ReplayThreadData,
  ThreadCalls,
  ThreadMethod,
  ToReplayThread,
} from './replay-messages.ts';

export interface WorkerReplayOptions extends ReplayThreadData {
  /** The built thread. */
  readonly workerFile: URL;
  readonly clock: Clock;
  readonly log: Log;
}

interface Call {
  readonly resolve: (value: unknown) => void;
  readonly reject: (error: ServiceError) => void;
}

/** Heap of the thread: twice what the longest index takes. */
const HEAP_MIB = 1024;

/** Plays recordings on a thread of its own, which runs while a file is open. [RP-15] */
export class WorkerReplayFiles implements ReplayFiles {
  readonly #options: WorkerReplayOptions;
  readonly #calls = new Map<number, Call>();
  readonly #sinks = new Map<number, PlayerSink>();
  #worker: Worker | undefined = undefined;
  #openFiles = 0;
  #lastNumber = 0;

  constructor(options: WorkerReplayOptions) {
    this.#options = options;
  }

  async open(recordingId: string): Promise<ReplayFile> {
    const file = ++this.#lastNumber;
    this.#openFiles++;
    try {
      return this.#fileOf(file, await this.#call('open', file, recordingId));
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
      await this.#call('close', file).catch(() => undefined); // A thread that ended has closed it.
      this.#release();
    };
    return {
      facts,
      session: (id, timeNs): Promise<RecordedSession | undefined> =>
        this.#call('session', file, id, timeNs),
      devices: (span) => this.#call('devices', file, span),
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
    void this.#call('play', file, player, part).catch(() => undefined); // `do` fails then, and says why.
    return {
      do: (command: PlayerCommand) => this.#call('do', player, command),
      close: () => {
        this.#sinks.delete(player);
        void this.#call('closePlayer', player).catch(() => undefined);
      },
    };
  }

  #call<M extends ThreadMethod>(
    method: M,
    ...args: Parameters<ThreadCalls[M]>
  ): ReturnType<ThreadCalls[M]> {
    const id = ++this.#lastNumber;
    return new Promise<unknown>((resolve, reject) => {
      this.#calls.set(id, { resolve, reject });
      this.#send({ kind: 'call', id, method, args });
    }) as ReturnType<ThreadCalls[M]>;
  }

  #send(message: ToReplayThread): void {
    try {
      this.#worker ??= this.#startThread();
      this.#worker.postMessage(message);
    } catch (error) {
      this.#fail(String(error));
    }
  }

  #startThread(): Worker {
    const { workerFile, folder } = this.#options;
    const workerData: ReplayThreadData = { folder };
    const worker: Worker = openThread<FromReplayThread>({
      ...{ workerFile, name: 'ubii replays', workerData, heapMib: HEAP_MIB },
      onMessage: (message) => {
        if (this.#worker === worker) this.#handle(message);
      },
      onEnd: (reason) => {
        if (this.#worker === worker) this.#fail(reason);
      },
    });
    return worker;
  }

  #handle(message: FromReplayThread): void {
    switch (message.kind) {
      case 'batch':
        return void this.#publish(message);
      case 'state':
        return this.#sinks.get(message.player)?.onState(message.state);
      case 'reply':
        return this.#takeCall(message.id)?.resolve(message.value);
      case 'refusal':
        return this.#takeCall(message.id)?.reject(new ServiceError(message.code, message.message));
    }
  }

  async #publish({ player, batch }: Extract<FromReplayThread, { kind: 'batch' }>): Promise<void> {
    await this.#sinks.get(player)?.onBatch(batch);
    if (this.#sinks.has(player)) this.#send({ kind: 'published', player });
  }

  #takeCall(id: number): Call | undefined {
    const call = this.#calls.get(id);
    this.#calls.delete(id);
    return call;
  }

  /** A file is closed. Without files, no thread is needed. */
  #release(): void {
    this.#openFiles--;
    if (this.#openFiles === 0) void this.#endThread();
  }

  async #endThread(): Promise<void> {
    const worker = this.#worker;
    this.#worker = undefined;
    this.#rejectCalls();
    await worker?.terminate();
  }

  /** The replays end; the next one has another thread. */
  #fail(reason: string): void {
    this.#options.log.error('replays ended, because their thread failed', { reason });
    const lost = [...this.#sinks.values()];
    this.#sinks.clear();
    void this.#endThread();
    for (const sink of lost) sink.onLost(reason);
  }

  #rejectCalls(): void {
    const calls = [...this.#calls.values()];
    this.#calls.clear();
    for (const { reject } of calls) {
      reject(new ServiceError('unavailable', 'The replay has ended. Start it again.'));
    }
  }
}
