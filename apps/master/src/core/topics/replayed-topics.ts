import type { Publication, PublishingClient } from './publication.ts';
import type { TopicEntry } from './topic-entry.ts';

/** What a replay does with live records on its topics. [RP-20] [RP-21] */
export interface LiveRule {
  /** Ids of the clients of the replay. */
  readonly clientIds: ReadonlySet<string>;
  /** Prefix under which live records are published; undefined: they are refused. */
  readonly livePrefix: string | undefined;
  /** Whether live records of this client are refused or moved. [RP-44] */
  mutes(clientId: string): boolean;
  /** Whether this record, with its new topic, may be published there. [RP-45] */
  mayMove(moved: Publication): boolean;
  /** The record was published there. */
  onMoved(moved: Publication): void;
  /** A live record of this topic was refused or moved. */
  onLive(topic: string): void;
}

/** The last live value of a replayed topic. */
export interface LiveValue {
  readonly topic: string;
  readonly client: PublishingClient;
  readonly record: Uint8Array;
  readonly valueField: number;
}

interface ReplayedTopic {
  readonly rule: LiveRule;
  /** A record of the replay was accepted: from then on, live records are muted. [RP-20] */
  isPlayed: boolean;
  live: LiveValue | undefined;
}

/** Bytes of live values that are remembered while their topics are replayed. */
const MAX_LIVE_BYTES = 64 * 1024 * 1024;

/** Topics of replays, and muting of live records there. */
export class ReplayedTopics {
  readonly #topics = new Map<string, ReplayedTopic>();
  #liveBytes = 0;

  /** The hot path looks here, and no further while nothing is replayed. [RP-24] */
  isActive = false;

  /** A replay is going to publish on this topic: the rule counts from the first record on that is accepted. */
  add(topic: string, rule: LiveRule): void {
    this.#topics.set(topic, { rule, isPlayed: false, live: undefined });
    this.isActive = true;
  }

  /** Whether a replay plays this topic. */
  has(topic: string): boolean {
    return this.isActive && this.#topics.get(topic)?.isPlayed === true;
  }

  /** Whether a record of this client, which may be of another master, is refused on the topic. */
  mutes(topic: string, clientId: string): boolean {
    if (!this.isActive) return false;
    const replayed = this.#topics.get(topic);
    return replayed?.isPlayed === true && replayed.rule.mutes(clientId);
  }

  /**
   * Takes note of a record that is about to be accepted.
   *
   * @returns the rule that it meets instead; undefined for all but muted records
   */
  ruleFor(publication: Publication): LiveRule | undefined {
    const replayed = this.#topics.get(publication.topic);
    if (replayed === undefined) return undefined;
    const { rule } = replayed;
    const { id } = publication.client!;
    if (rule.clientIds.has(id)) {
      if (!replayed.isPlayed) this.#begin(replayed, publication.entry);
      return undefined;
    }
    if (!replayed.isPlayed) return undefined;
    if (rule.mutes(id)) return rule;
    this.#keepRecord(replayed, publication);
    return undefined;
  }

  /** Remembers a live record, which is not published on its topic. [RP-23] */
  keepLive(publication: Publication): void {
    const replayed = this.#topics.get(publication.topic)!;
    this.#keepRecord(replayed, publication);
    replayed.rule.onLive(publication.topic);
  }

  /** Ends a rule. Returns the last live value of each of its topics. */
  remove(rule: LiveRule): LiveValue[] {
    const values: LiveValue[] = [];
    for (const [topic, replayed] of this.#topics) {
      if (replayed.rule !== rule) continue;
      this.#topics.delete(topic);
      if (replayed.live === undefined) continue;
      values.push(replayed.live);
      this.#liveBytes -= replayed.live.record.byteLength;
    }
    this.isActive = this.#topics.size > 0;
    return values;
  }

  /** Remembers the value from before the replay. */
  #begin(replayed: ReplayedTopic, entry: TopicEntry | undefined): void {
    replayed.isPlayed = true;
    if (entry?.record === undefined || entry.owner === undefined) return;
    const { topic, record, valueField } = entry;
    // Owners publish: they are clients, or sessions on the master.
    this.#keep(replayed, {
      topic,
      record,
      valueField,
      client: entry.owner as PublishingClient,
    });
  }

  #keepRecord(replayed: ReplayedTopic, publication: Publication): void {
    const { topic, client, valueField } = publication;
    this.#keep(replayed, { topic, client: client!, record: publication.keepRecord(), valueField });
  }

  #keep(replayed: ReplayedTopic, live: LiveValue): void {
    const bytes = this.#liveBytes - (replayed.live?.record.byteLength ?? 0);
    const isTooMuch = bytes + live.record.byteLength > MAX_LIVE_BYTES;
    replayed.live = isTooMuch ? undefined : live;
    this.#liveBytes = isTooMuch ? bytes : bytes + live.record.byteLength;
  }
}
