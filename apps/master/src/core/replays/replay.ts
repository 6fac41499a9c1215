import {
  ReplayAction,
  ReplayState,
  type Recording,
  type Replay as ReplayMessage,
  type ReplayChangeRequest,
  type ReplayStartRequest,
} from '@ubii/proto';
import type { RecordedDevice, RecordedTopic } from '@ubii/recording';
import { TokenBucket, type Cancel } from '@ubii/timing';
import type { ClientAccess } from '../access/caller.ts';
import type { Limits } from '../limits/index.ts';
import type {
  PlayedBatch,
  PlayerCommand,
  PlayerState,
  ReplayFile,
  ReplayPlayer,
} from '../ports/replay-files.ts';
import { publicName } from '../recordings/public-name.ts';
import { ghostDevices } from './ghost-devices.ts';
import { LiveMuting, type MutingContext } from './live-muting.ts';
import { ghostTopics, renamedTopics, requireMovable, type PlayedTopics } from './played-topics.ts';
import { replayName } from './replay-name.ts';
import { ReplayClient, type ReplayClientContext } from './replay-client.ts';
import type { Rerun } from './rerun.ts';
import { momentOf, msBetween, rateOf, spanOf, type ReplayWish } from './replay-wish.ts';

/** What a replay works with. */
export interface ReplayContext extends MutingContext, ReplayClientContext {
  readonly limits: Limits;
}

/** What is played, for whom. */
export interface ReplayInit {
  readonly id: string;
  readonly request: ReplayStartRequest;
  readonly wish: ReplayWish;
  readonly file: ReplayFile;
  readonly recording: Recording;
  /** Topics that are played, as recorded. */
  readonly recorded: readonly RecordedTopic[];
  /** Devices of the span, for a ghost; none for other replays. */
  readonly devices: readonly RecordedDevice[];
  readonly author: string;
  readonly makerId: string;
  readonly access: ClientAccess;
  /** Numbers of the copies, among those of all ghosts. */
  readonly numbers: readonly number[];
  /** The session that runs again on what is played; undefined when none does. */
  readonly rerun?: Rerun;
  /** Something of it changed. */
  onChange(): void;
  /** It cannot go on: its client was disconnected, or the thread failed. */
  onEnd(): void;
}

/** Memory for what is read ahead, of all copies together, bytes. */
const READ_AHEAD_BYTES = 16 * 1024 * 1024;

interface Copy {
  readonly client: ReplayClient;
  readonly player: ReplayPlayer;
}

/** A recording that is played into live topics. */
export class Replay {
  readonly parts: ReplayInit;
  /** Names of the topics that it plays, as far as its starter may publish there. */
  readonly plannedTopics: ReadonlySet<string>;
  readonly #context: ReplayContext;
  readonly #copies: Copy[] = [];
  readonly #clientIds = new Set<string>();
  readonly #muting: LiveMuting;
  readonly #bucket: TokenBucket;
  readonly #topics = new Set<string>();
  readonly #startedMs: number;
  readonly #cancels = new Set<Cancel>();
  #publishing: Promise<void> = Promise.resolve();
  #state: PlayerState;
  #wish: ReplayWish;
  #refusal = '';
  #isClosed = false;

  /** @throws ServiceError when there is no room for its clients, or its topics cannot be published */
  constructor(context: ReplayContext, parts: ReplayInit) {
    const { wish, file, access } = parts;
    this.#context = context;
    this.parts = parts;
    this.#wish = wish;
    this.#startedMs = context.clock.nowMs();
    this.#state = { status: 'paused', positionNs: wish.span.fromNs, problem: '' };
    const perSecond = context.limits.replayRecordsPerSecond;
    // A tenth of a second at once: what one turn publishes stays small.
    this.#bucket = new TokenBucket(perSecond, context.clock.monotonicMs(), perSecond / 10);
    const isOfAdmin = access.role === 'admin';
    this.#muting = new LiveMuting(context, wish, this.#clientIds, isOfAdmin, parts.onChange);
    const planned = new Set<string>();
    try {
      for (let copy = 0; copy < wish.copies; copy++) {
        for (const name of this.#open(copy, file)) planned.add(name);
      }
      if (wish.livePrefix !== '') {
        requireMovable(planned, wish.livePrefix, context.limits.topicBytes, (topic) =>
          this.#muting.mayMoveTo(topic),
        );
      }
    } catch (cause) {
      this.close();
      throw cause;
    }
    this.plannedTopics = planned;
  }

  get isGhost(): boolean {
    return this.parts.request.isGhost;
  }

  /** Publishes the values at the start of the span, and plays. */
  async begin(): Promise<void> {
    const { rate, span, isLooping, jitterMs, copies } = this.#wish;
    await this.parts.rerun?.start();
    await this.#all({ kind: 'span', span, isLooping });
    await this.#all({ kind: 'rate', rate });
    await this.#all({ kind: 'seek', positionNs: span.fromNs });
    if (this.parts.request.isPaused) return;
    for (const [index, { player }] of this.#copies.entries()) {
      const delayMs = (jitterMs * index) / copies; // [RP-32]
      if (delayMs === 0) await player.do({ kind: 'play' });
      else this.#playLater(player, delayMs);
    }
  }

  /** [RP-5] @throws ServiceError when it asks for what there is not */
  async change({ rate, loop, seek, step, action }: ReplayChangeRequest): Promise<void> {
    const { facts } = this.parts.file;
    const commands: PlayerCommand[] = [];
    if (rate !== 0) commands.push({ kind: 'rate', rate: rateOf(rate) });
    if (loop !== undefined) {
      const { isLooping } = loop;
      commands.push({ kind: 'span', span: spanOf(loop.span, facts), isLooping });
    }
    if (seek !== undefined) {
      commands.push({ kind: 'seek', positionNs: momentOf(seek.positionMs, facts.startNs) });
    }
    if (step !== 0) commands.push({ kind: 'step', moments: step });
    if (action === ReplayAction.REPLAY_ACTION_PLAY) commands.push({ kind: 'play' });
    if (action === ReplayAction.REPLAY_ACTION_PAUSE) commands.push({ kind: 'pause' });
    if (commands.length > 0) this.#cancelStarts();
    for (const command of commands) {
      this.#remember(command);
      await this.#all(command);
    }
    this.parts.onChange();
  }

  /** Gives back all that it took. */
  close(): void {
    if (this.#isClosed) return;
    this.#isClosed = true;
    this.#cancelStarts();
    this.parts.rerun?.close();
    for (const { player } of this.#copies) player.close();
    const live = this.#muting.end();
    for (const { client } of this.#copies) client.close();
    this.#muting.restore(live);
    void this.parts.file.close().catch(() => undefined);
  }

  toMessage(): ReplayMessage {
    const { id, recording, author, file } = this.parts;
    const { rate, span, isLooping, copies, conflict, livePrefix } = this.#wish;
    const { startNs, endNs } = file.facts;
    const traffic = this.#copies.map(({ client }) => client.client.traffic);
    const { problem } = this.#state;
    return {
      id,
      author,
      rate,
      isLooping,
      copies,
      conflict,
      livePrefix,
      name: this.#copies[0]?.client.client.spec.name ?? '',
      recordingId: recording.id,
      recordingName: publicName(recording), // [ST-54]
      state: this.#wireState(),
      positionMs: msBetween(startNs, this.#state.positionNs),
      durationMs: msBetween(startNs, endNs),
      span: { fromMs: msBetween(startNs, span.fromNs), untilMs: msBetween(startNs, span.untilNs) },
      isGhost: this.isGhost,
      clientIds: [...this.#clientIds],
      topicCount: this.#topics.size,
      recordCount: traffic.reduce((sum, { recordsIn }) => sum + recordsIn, 0),
      mutedCount: this.#muting.count,
      mutedTopics: this.#muting.topics,
      refusedCount: traffic.reduce((sum, { refused }) => sum + refused, 0),
      problem: problem || this.#refusal || (this.parts.rerun?.problem ?? ''),
      session: this.parts.rerun?.toMessage(),
      startedMs: this.#startedMs,
      recordingStartedMs: msBetween(0n, startNs),
    };
  }

  /** Makes one copy: a client with its player. Returns the topics on which it may publish. */
  #open(copy: number, file: ReplayFile): string[] {
    const { request, wish, access, onEnd } = this.parts;
    const client = new ReplayClient(this.#context, {
      access,
      name: replayName(this.parts, copy, this.#context.limits.nameCharacters),
      onError: (message) => (this.#refusal = message),
      onClosed: onEnd,
    });
    try {
      const topics = this.#topicsOf(client.id, copy);
      client.register(
        ghostDevices(this.parts.devices, topics, client.id, (each) => client.mayHave(each)),
      );
      const part = {
        topics: [...topics],
        clientId: request.isGhost ? client.id : undefined,
        keepsTimestamps: request.keepsTimestamps,
        readAheadBytes: READ_AHEAD_BYTES / wish.copies,
      };
      const player = file.play(part, {
        onBatch: (batch) => this.#publish(client, batch),
        onState: (state) => this.#handleState(state, copy),
        onLost: onEnd,
      });
      this.#copies.push({ client, player });
      this.#clientIds.add(client.id);
      return [...topics.values()].filter((topic) => client.mayPublish(topic));
    } catch (cause) {
      client.close();
      throw cause;
    }
  }

  #topicsOf(clientId: string, copy: number): PlayedTopics {
    const { request, recorded, numbers, rerun } = this.parts;
    if (request.isGhost) return ghostTopics(recorded, clientId, numbers[copy]!);
    const renames =
      rerun === undefined ? request.renames : [{ fromPrefix: '', toPrefix: rerun.inputPrefix }];
    return renamedTopics(recorded, renames, this.#context.limits.topicBytes);
  }

  /** Publishes a batch when all before it are, and as soon as the rate allows. [RP-14] */
  #publish(client: ReplayClient, batch: PlayedBatch): Promise<void> {
    this.#publishing = this.#publishing.then(async () => {
      const { clock } = this.#context;
      // Others have their turn between two batches.
      await new Promise<void>((resolve) =>
        clock.after(this.#bucket.waitMs(clock.monotonicMs()), resolve),
      );
      if (this.#isClosed) return;
      this.#bucket.spend(batch.records, clock.monotonicMs());
      for (const topic of batch.newTopics) {
        this.#topics.add(topic);
        if (this.plannedTopics.has(topic)) this.#muting.add(topic);
      }
      client.publish(batch.frame);
    });
    return this.#publishing;
  }

  #handleState(state: PlayerState, copy: number): void {
    if (copy !== 0 || this.#isClosed) return;
    this.#state = state;
    if (state.status === 'ended') this.parts.rerun?.finish(this.parts.onChange);
    this.parts.onChange();
  }

  #remember(command: PlayerCommand): void {
    if (command.kind === 'rate') this.#wish = { ...this.#wish, rate: command.rate };
    if (command.kind !== 'span') return;
    const { span, isLooping } = command;
    this.#wish = { ...this.#wish, span, isLooping };
  }

  async #all(command: PlayerCommand): Promise<void> {
    await Promise.all(this.#copies.map(({ player }) => player.do(command)));
  }

  #playLater(player: ReplayPlayer, delayMs: number): void {
    const cancel = this.#context.clock.after(delayMs, () => {
      this.#cancels.delete(cancel);
      void player.do({ kind: 'play' }).catch(() => undefined);
    });
    this.#cancels.add(cancel);
  }

  #cancelStarts(): void {
    for (const cancel of this.#cancels) cancel();
    this.#cancels.clear();
  }

  #wireState(): ReplayState {
    const { status, problem } = this.#state;
    if (problem !== '') return ReplayState.REPLAY_STATE_FAILED;
    if (status === 'playing') return ReplayState.REPLAY_STATE_PLAYING;
    return status === 'ended' ? ReplayState.REPLAY_STATE_ENDED : ReplayState.REPLAY_STATE_PAUSED;
  }
}
