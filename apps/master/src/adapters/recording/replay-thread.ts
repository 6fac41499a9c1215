import type { RecordedDevice, RecordedSession, Span } from '@ubii/recording';
import { ServiceError } from '@ubii/proto';

import type {
  PlayedBatch,
  PlayedPart,
  PlayerCommand,
  ReplayFacts,
  ReplayFile,
  ReplayFiles,
  ReplayPlayer,
} from '../../core/ports/index.ts';
import type { FromReplayThread, ThreadCalls, ToReplayThread } from './replay-messages.ts';

/** Gives a message to the other side. @param transfer memory that is handed over */
export type Post = (message: FromReplayThread, transfer?: readonly ArrayBuffer[]) => void;

/** The side of the thread: opens files and plays them, as it is told. */
export class ReplayThread implements ThreadCalls {
  readonly #files: ReplayFiles;
  readonly #post: Post;
  readonly #open = new Map<number, ReplayFile>();
  readonly #players = new Map<number, ReplayPlayer>();
  /** Resolve when the oldest batches of a player are published. */
  readonly #published = new Map<number, (() => void)[]>();

  constructor(files: ReplayFiles, post: Post) {
    this.#files = files;
    this.#post = post;
  }

  handle(message: ToReplayThread): void {
    if (message.kind === 'published') return this.#published.get(message.player)?.shift()?.();
    void this.#answer(message);
  }

  async open(file: number, recordingId: string): Promise<ReplayFacts> {
    const opened = await this.#files.open(recordingId);
    this.#open.set(file, opened);
    return opened.facts;
  }

  session(file: number, id: string, timeNs: bigint): Promise<RecordedSession | undefined> {
    return require(this.#open, file).session(id, timeNs);
  }

  devices(file: number, span: Span): Promise<readonly RecordedDevice[]> {
    return require(this.#open, file).devices(span);
  }

  play(file: number, player: number, part: PlayedPart): Promise<void> {
    this.#published.set(player, []);
    const played = require(this.#open, file).play(part, {
      onBatch: (batch) => this.#send(player, batch),
      onState: (state) => this.#post({ kind: 'state', player, state }),
      onLost: () => undefined, // Players of a folder are not lost.
    });
    this.#players.set(player, played);
    return Promise.resolve();
  }

  do(player: number, command: PlayerCommand): Promise<void> {
    return require(this.#players, player).do(command);
  }

  closePlayer(player: number): Promise<void> {
    this.#players.get(player)?.close();
    this.#players.delete(player);
    this.#published.delete(player);
    return Promise.resolve();
  }

  async close(file: number): Promise<void> {
    const open = this.#open.get(file);
    this.#open.delete(file);
    await open?.close();
  }

  #send(player: number, batch: PlayedBatch): Promise<void> {
    const waiting = this.#published.get(player);
    if (waiting === undefined) return Promise.resolve();
    return new Promise((resolve) => {
      waiting.push(resolve);
      // The frame has memory of its own.
      this.#post({ kind: 'batch', player, batch }, [batch.frame.buffer as ArrayBuffer]);
    });
  }

  async #answer({ id, method, args }: Extract<ToReplayThread, { kind: 'call' }>): Promise<void> {
    try {
      // The other side calls it by the types of `ThreadCalls`.
      const call = this[method].bind(this) as (...args: unknown[]) => Promise<unknown>;
      this.#post({ kind: 'reply', id, value: await call(...args) });
    } catch (error) {
      const { code, message } = ServiceError.from(error);
      this.#post({ kind: 'refusal', id, code, message });
    }
  }
}

function require<T>(known: ReadonlyMap<number, T>, number: number): T {
  const found = known.get(number);
  if (found === undefined) throw new ServiceError('unavailable', 'The replay has ended.');
  return found;
}
