import {
  encode,
  INFO_TOPICS,
  moduleEventTopic,
  sessionStatisticsTopic,
  timestampFromMs,
  type ModuleEvent,
  type SessionStatistics,
} from '@ubii/proto';
import type { Client } from '../clients/client.ts';
import type { MasterPublisher } from '../info/master-publisher.ts';
import type { Clock } from '../ports/clock.ts';
import type { SubscriptionTable } from '../topics/subscription-table.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import type { Session } from './session.ts';

/** What news of sessions are published with. */
export interface NewsContext {
  readonly publisher: MasterPublisher;
  readonly topics: TopicTable;
  readonly subscriptions: SubscriptionTable;
  readonly clock: Clock;
}

/** Tells everybody what becomes of sessions, each time with the whole session [SE-8]. */
export class SessionNews {
  readonly #context: NewsContext;

  constructor(context: NewsContext) {
    this.#context = context;
  }

  announceNew(session: Session): void {
    this.#publish(INFO_TOPICS.newSession, session);
  }

  announceChange(session: Session): void {
    this.#publish(INFO_TOPICS.changeSession, session);
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
    this.#publish(INFO_TOPICS.deleteSession, session);
    this.#context.publisher.deleteValue(sessionStatisticsTopic(session.id));
    this.#context.publisher.deleteValue(moduleEventTopic(session.id));
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
  tellNode(
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

  #publish(topic: string, session: Session): void {
    this.#context.publisher.publish(topic, { session: session.toMessage() });
  }
}
