import {
  RecordingState,
  ServiceError,
  type Replay as ReplayMessage,
  type ReplayChangeRequest,
  type ReplayStartRequest,
} from '@ubii/proto';
import { grantOfAccess, type ClientAccess } from '../access/caller.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { MasterPublisher } from '../info/master-publisher.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { ReplayFiles } from '../ports/replay-files.ts';
import { quote } from '../texts/quote.ts';
import { chosenTopics } from './played-topics.ts';
import { ReplayNews } from './replay-news.ts';
import { Replay, type ReplayContext, type ReplayInit } from './replay.ts';
import { Rerun, type RerunContext } from './rerun.ts';
import { wishOf } from './replay-wish.ts';

/** What replays work with. */
export interface ReplaysContext extends ReplayContext, RerunContext {
  readonly ids: IdSource;
  readonly limitWatch: LimitWatch;
  readonly publisher: MasterPublisher;
  readonly replayFiles: ReplayFiles;
}

/** Who starts a replay. */
export interface ReplayAuthor {
  /** Name of the client; empty when none asks. */
  readonly author: string;
  /** Whose the replay and its comparison are. [RC-66] */
  readonly makerId: string;
  /** Rights and share of the clients of the replay. */
  readonly access: ClientAccess;
}

type Facts = Omit<ReplayInit, 'numbers' | 'onChange' | 'onEnd' | 'recorded'>;

/** All replays of a master. */
export class Replays {
  readonly #context: ReplaysContext;
  readonly #news: ReplayNews;
  readonly #replays = new Map<string, Replay>();
  #starting = 0;

  constructor(context: ReplaysContext) {
    const { publisher, clock, recordings } = context;
    this.#context = context;
    this.#news = new ReplayNews(publisher, clock, () => this.list());
    recordings.onDelete.add((id) => this.#endThose((recordingId) => recordingId === id));
    recordings.onListChanged.add(() => void this.#endDeleted().catch(() => undefined));
  }

  list(): ReplayMessage[] {
    return [...this.#replays.values()].map((replay) => replay.toMessage());
  }

  /** @throws ServiceError when there is none of this id */
  require(id: string): Replay {
    const replay = this.#replays.get(id);
    if (replay !== undefined) return replay;
    throw new ServiceError('not_found', `No replay has the id "${id}".`);
  }

  /** [RP-1] */
  async start(request: ReplayStartRequest, author: ReplayAuthor): Promise<ReplayMessage> {
    const { limitWatch } = this.#context;
    const max = limitWatch.limits.runningReplays;
    if (this.#replays.size + this.#starting >= max) {
      throw limitWatch.refusal('runningReplays', `more than ${max} replays at once`);
    }
    this.#starting++;
    let replay: Replay;
    try {
      replay = await this.#open(request, author);
    } finally {
      this.#starting--;
    }
    this.#replays.set(replay.parts.id, replay);
    try {
      await replay.begin();
    } catch (cause) {
      this.#end(replay);
      throw cause;
    }
    this.#news.announce();
    return replay.toMessage();
  }

  /** [RP-5] */
  async change(request: ReplayChangeRequest): Promise<ReplayMessage> {
    const replay = this.require(request.id);
    await replay.change(request);
    return replay.toMessage();
  }

  /** [RP-6] */
  stop(id: string): void {
    this.#end(this.require(id));
  }

  /** Stops all. */
  close(): void {
    this.#endThose(() => true);
    this.#news.close();
  }

  async #open(request: ReplayStartRequest, author: ReplayAuthor): Promise<Replay> {
    const { ids, limitWatch, recordings, replayFiles } = this.#context;
    const { recording } = await recordings.get(request.recordingId);
    if (recording.state === RecordingState.RECORDING_STATE_RECORDING) {
      throw new ServiceError(
        'failed_precondition',
        `The recording ${quote(recording.name)} is still running. Stop it before you play it.`,
      );
    }
    if (recording.state === RecordingState.RECORDING_STATE_REJECTED) {
      throw new ServiceError('failed_precondition', `${recording.problem} It cannot be played.`);
    }
    const file = await replayFiles.open(request.recordingId);
    try {
      const id = ids.uuid();
      const wish = wishOf(request, file.facts, limitWatch);
      const chosen = chosenTopics(file.facts.topics, request);
      const devices = request.isGhost ? await file.devices(wish.span) : [];
      const facts = { id, request, wish, file, recording, devices, ...author };
      if (request.sessionId === '') return this.#create({ ...facts, recorded: chosen });
      const rerun = await this.#rerunOf(facts);
      const recorded = chosen.filter(({ topic }) => rerun.readsTopic(topic));
      if (recorded.length === 0) throw nothingToRead();
      return this.#create({ ...facts, recorded, rerun });
    } catch (cause) {
      await file.close();
      throw cause;
    }
  }

  #rerunOf({ id, request, wish, file, recording, ...by }: Facts): Promise<Rerun> {
    const { sessionId } = request;
    const { author, makerId, access } = by;
    const grantId = grantOfAccess(access);
    const what = { replayId: id, sessionId, recording, author, makerId, grantId };
    return Rerun.prepare(this.#context, what, file, wish.span);
  }

  #create(facts: Omit<ReplayInit, 'numbers' | 'onChange' | 'onEnd'>): Replay {
    const { request, wish } = facts;
    const replay: Replay = new Replay(this.#context, {
      ...facts,
      numbers: this.#freeNumbers(request.isGhost ? wish.copies : 0),
      onChange: () => this.#news.announce(),
      onEnd: () => this.#end(replay),
    });
    try {
      this.#requireFree(replay);
    } catch (cause) {
      replay.close();
      throw cause;
    }
    return replay;
  }

  /** [RP-4] */
  #requireFree({ isGhost, plannedTopics }: Replay): void {
    if (isGhost) return;
    for (const other of this.#replays.values()) {
      if (other.isGhost) continue;
      for (const topic of plannedTopics) {
        if (!other.plannedTopics.has(topic)) continue;
        throw new ServiceError(
          'failed_precondition',
          `The replay ${quote(other.toMessage().name)} plays the topic ${quote(topic)} already. Stop it, or rename the topic.`,
        );
      }
    }
  }

  /** Numbers that no copy of a ghost has. [RP-31] */
  #freeNumbers(count: number): number[] {
    const used = new Set([...this.#replays.values()].flatMap(({ parts }) => parts.numbers));
    const free: number[] = [];
    for (let number = 1; free.length < count; number++) if (!used.has(number)) free.push(number);
    return free;
  }

  /** The recorder itself may have deleted recordings. [RC-18] */
  async #endDeleted(): Promise<void> {
    if (this.#replays.size === 0) return;
    const { elements } = await this.#context.recordings.list();
    const ids = new Set(elements.map(({ id }) => id));
    this.#endThose((id) => !ids.has(id));
  }

  #endThose(isMeant: (recordingId: string) => boolean): void {
    for (const replay of this.#replays.values()) {
      if (isMeant(replay.parts.request.recordingId)) this.#end(replay);
    }
  }

  #end(replay: Replay): void {
    if (!this.#replays.delete(replay.parts.id)) return;
    replay.close();
    this.#news.announce();
  }
}

function nothingToRead(): ServiceError {
  return new ServiceError(
    'invalid_argument',
    'The recording has no selected topic that the session reads, so there is nothing to run it on.',
  );
}
