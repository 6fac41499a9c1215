import {
  encode,
  INFO_TOPICS,
  moduleEventTopic,
  sessionStatisticsTopic,
  timestampFromMs,
  type ModuleEvent,
  type Session as SessionMessage,
  type SessionStatistics,
} from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { Client } from '../clients/client.ts';
import type { MasterPublisher } from '../info/master-publisher.ts';
import { Hook } from '../hooks/hook.ts';
import { PacedAnnouncements } from '../info/paced-announcements.ts';
import type { Limits } from '../limits/index.ts';
import type { SubscriptionTable } from '../topics/subscription-table.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import type { Session } from './session.ts';

/** Dependencies for announcing sessions. */
export interface NewsContext {
  readonly publisher: MasterPublisher;
  readonly topics: TopicTable;
  readonly subscriptions: SubscriptionTable;
  readonly clock: Clock;
  readonly limits: Limits;
}

/** Seconds of news of one session that may come at once. */
const BURST_SECONDS = 4;

/** Announces changes of sessions, each time with the whole session [SE-8]. */
export class SessionNews {
  /** Called with each announcement, which other masters pass on to their clients. [CU-30] */
  readonly onNews = new Hook<[topic: string, session: SessionMessage]>();
  readonly #context: NewsContext;
  readonly #changes: PacedAnnouncements;

  constructor(context: NewsContext) {
    this.#context = context;
    const { sessionNewsBytesPerSecond: bytesPerSecond } = context.limits;
    const burstBytes = BURST_SECONDS * bytesPerSecond;
    this.#changes = new PacedAnnouncements(context.clock, { bytesPerSecond, burstBytes });
  }

  announceNew(session: Session): void {
    this.#publish(INFO_TOPICS.newSession, session);
  }

  /** [EX-75] */
  announceChange(session: Session): void {
    this.#changes.announce(session.id, () => this.#announce(INFO_TOPICS.changeSession, session));
  }

  /** Tells nodes to run their modules [SE-11]. */
  announceStart(session: Session): void {
    this.#publish(INFO_TOPICS.startSession, session);
  }

  /** [SE-12] */
  announceRunning(session: Session): void {
    this.#publish(INFO_TOPICS.runningSession, session);
  }

  /** Tells nodes to end their modules [SE-13]. */
  announceStop(session: Session): void {
    this.#publish(INFO_TOPICS.stopSession, session);
  }

  /** The last news of a session, which is forgotten [SE-16]. */
  announceGone(session: Session): void {
    this.#changes.forget(session.id);
    this.#publish(INFO_TOPICS.deleteSession, session);
    this.#context.publisher.deleteValue(sessionStatisticsTopic(session.id));
    this.#context.publisher.deleteValue(moduleEventTopic(session.id));
  }

  /** Ends every timer. */
  close(): void {
    this.#changes.close();
  }

  /** [SE-50] */
  publishStatistics(sessionStatistics: SessionStatistics): void {
    const topic = sessionStatisticsTopic(sessionStatistics.sessionId);
    this.#context.publisher.publish(topic, { sessionStatistics });
  }

  /** [SE-51] */
  publishEvent(moduleEvent: ModuleEvent): void {
    this.#context.publisher.publish(moduleEventTopic(moduleEvent.sessionId), { moduleEvent });
  }

  /**
   * Tells one node alone that a session starts or stops, as far as it listens: others would take it for
   * news [SE-33].
   * @param session The session, with the modules the node is to know of.
   */
  sendToNode(
    client: Client,
    what: 'startSession' | 'stopSession',
    session: ReturnType<Session['toMessage']>,
  ): void {
    const { topics, subscriptions, clock } = this.#context;
    const topic = INFO_TOPICS[what];
    const entry = topics.get(topic);
    if (entry === undefined || !subscriptions.isSubscribed(client.subscriber, entry)) return;
    const timestamp = timestampFromMs(clock.nowMs());
    const record = encode('ubii.topicData.TopicDataRecord', { topic, timestamp, session });
    client.subscriber.outbox.deliver(entry, record, true);
  }

  #announce(topic: string, session: Session): number {
    const message = session.toMessage();
    this.onNews.emit(topic, message);
    return this.#context.publisher.publish(topic, { session: message });
  }

  #publish(topic: string, session: Session): void {
    const bytes = this.#announce(topic, session);
    // Commands to start and stop are never delayed; they use up the budget of change announcements.
    if (topic !== INFO_TOPICS.deleteSession) this.#changes.spend(session.id, bytes);
  }
}
