import { isMasterTopic, ReplayConflict } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import { namespaceOwner } from '../access/topic-rights.ts';
import type { ClientRegistry } from '../clients/client-registry.ts';
import { Publication } from '../topics/publication.ts';
import { publish, type PublishContext } from '../topics/publisher.ts';
import type { LiveRule, LiveValue } from '../topics/replayed-topics.ts';
import type { TopicEntry, TopicOwner } from '../topics/topic-entry.ts';
import type { ReplayWish } from './replay-wish.ts';

/** What muting works with. */
export interface MutingContext extends PublishContext {
  readonly clock: Clock;
  readonly clients: ClientRegistry;
}

/** Muted topics that are named. [RP-20] */
const MAX_NAMED = 100;
/** Time between two notifications that more records were muted, milliseconds. [RP-7] */
const NEWS_MS = 1_000;

/** What one replay does to live records on its topics, and how it ends. */
export class LiveMuting {
  readonly #context: MutingContext;
  readonly #conflict: ReplayConflict;
  readonly #rule: LiveRule;
  readonly #muted = new Set<string>();
  /** Topics that have moved records, with their owners. */
  readonly #moved = new Map<string, TopicOwner | undefined>();
  #count = 0;
  #cancelNews: Cancel | undefined = undefined;

  constructor(
    context: MutingContext,
    { conflict, livePrefix }: Pick<ReplayWish, 'conflict' | 'livePrefix'>,
    clientIds: ReadonlySet<string>,
    isOfAdmin: boolean,
    onGrow: () => void,
  ) {
    this.#context = context;
    this.#conflict = conflict;
    this.#rule = {
      clientIds,
      livePrefix: livePrefix === '' ? undefined : livePrefix,
      mutes: (id) => isOfAdmin || context.clients.get(id)?.access.role !== 'admin',
      mayMove: ({ topic, entry }) =>
        this.mayMoveTo(topic) && (entry?.record === undefined || this.#isMoved(entry)),
      onMoved: ({ entry }) => this.#moved.set(entry!.topic, entry!.owner),
      onLive: (topic) => {
        this.#count++;
        this.#muted.add(topic);
        this.#cancelNews ??= context.clock.after(NEWS_MS, () => {
          this.#cancelNews = undefined;
          onGrow();
        });
      },
    };
  }

  /** Live records that were refused or moved. */
  get count(): number {
    return this.#count;
  }

  /** Topics of these, the first of them. */
  get topics(): string[] {
    return [...this.#muted].slice(0, MAX_NAMED);
  }

  /** The replay publishes on this topic from now on. */
  add(topic: string): void {
    if (this.#conflict === ReplayConflict.REPLAY_CONFLICT_KEEP_LIVE) return;
    this.#context.replayed.add(topic, this.#rule);
  }

  /** Live records may be moved to this topic: the starter has the rights, and no client owns it. [RP-45] */
  mayMoveTo(topic: string): boolean {
    const { clients, replayed } = this.#context;
    if (isMasterTopic(topic) || replayed.has(topic)) return false;
    if (namespaceOwner(topic, clients) !== undefined) return false;
    const [id = ''] = this.#rule.clientIds;
    const rights = clients.get(id)?.publishRights;
    return rights === undefined || rights.mayPublish(topic);
  }

  /** Lets live records flow again. Call `restore` when the topics of the replay are gone. */
  end(): LiveValue[] {
    this.#cancelNews?.();
    const { replayed, topics } = this.#context;
    for (const topic of this.#moved.keys()) {
      const entry = topics.get(topic);
      if (entry !== undefined && this.#isMoved(entry)) topics.deleteValue(entry);
    }
    return replayed.remove(this.#rule);
  }

  /** Whether the value of a topic came by a move, and from no other publisher since. */
  #isMoved(entry: TopicEntry): boolean {
    const { topic, owner, isAdoptable } = entry;
    return this.#moved.has(topic) && (isAdoptable || this.#moved.get(topic) === owner);
  }

  /** Gives topics their last live values. [RP-23] */
  restore(values: readonly LiveValue[]): void {
    const { clients, topics, clock } = this.#context;
    for (const { topic, client, record, valueField } of values) {
      const isPresent = clients.get(client.id) === client || topics.get(topic)?.owner === client;
      if (!isPresent) continue;
      const publication = new Publication();
      publication.client = client;
      publication.topic = topic;
      publication.frame = record;
      publication.start = 0;
      publication.end = record.byteLength;
      publication.valueField = valueField;
      publication.nowMs = clock.nowMs();
      publication.monotonicMs = clock.monotonicMs();
      publish(this.#context, publication);
    }
  }
}
