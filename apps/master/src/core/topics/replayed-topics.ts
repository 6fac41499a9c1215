import type { Publication, PublishingClient } from './publication.ts';
import type { TopicEntry } from './topic-entry.ts';

/** What a replay does with live records on its topics. [RP-20] [RP-21] */
export interface LiveRule {
  /** Ids of the clients of the replay. */
  readonly clientIds: ReadonlySet<string>;
  /** Prefix under which live records are published; undefined: they are refused. */
  readonly livePrefix: string | undefined;
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
  live: LiveValue | undefined;
}

/** Bytes of live values that are remembered while their topics are replayed. */
const MAX_LIVE_BYTES = 64 * 1024 * 1024;

/** Topics that replays play, and what becomes of live records there. */
export class ReplayedTopics {
  readonly #topics = new Map<string, ReplayedTopic>();
  #liveBytes = 0;

  /** The hot path looks here, and no further while nothing is replayed. [RP-24] */
  isActive = false;

  /** From now on, the rule counts for this topic. @param entry the topic, if there is one */
  add(topic: string, rule: LiveRule, entry: TopicEntry | undefined): void {
    const replayed: ReplayedTopic = { rule, live: undefined };
    this.#topics.set(topic, replayed);
    this.isActive = true;
    if (entry?.record === undefined || entry.owner === undefined) return;
    const { record, valueField } = entry;
    // Owners publish: they are clients, or sessions on the master.
    this.#keep(replayed, {
      ...{ topic, record, valueField },
      client: entry.owner as PublishingClient,
    });
  }

  /** Whether a replay plays this topic. */
  has(topic: string): boolean {
    return this.isActive && this.#topics.has(topic);
  }

  /** The rule for a record of a client; undefined for all but live records on replayed topics. */
  ruleFor({ topic, client }: Publication): LiveRule | undefined {
    const rule = this.#topics.get(topic)?.rule;
    return rule === undefined || rule.clientIds.has(client!.id) ? undefined : rule;
  }

  /** Remembers a live record, which is not published on its topic. [RP-23] */
  keepLive(publication: Publication): void {
    const { topic, client, valueField } = publication;
    const replayed = this.#topics.get(topic)!;
    this.#keep(replayed, { topic, client: client!, record: publication.keepRecord(), valueField });
    replayed.rule.onLive(topic);
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

  #keep(replayed: ReplayedTopic, live: LiveValue): void {
    const bytes = this.#liveBytes - (replayed.live?.record.byteLength ?? 0);
    const isTooMuch = bytes + live.record.byteLength > MAX_LIVE_BYTES;
    replayed.live = isTooMuch ? undefined : live;
    this.#liveBytes = isTooMuch ? bytes : bytes + live.record.byteLength;
  }
}
