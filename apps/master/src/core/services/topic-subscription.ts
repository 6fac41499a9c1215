import { ServiceError, type TopicSubscription } from '@ubii/proto';
import { JOINED } from '../access/roles.ts';
import type { Core } from '../areas/core.ts';
import type { Subscriber, TopicEntry } from '../topics/topic-entry.ts';
import { definer, success } from './define-service.ts';
import { requireElements } from './list-limits.ts';
import { replayAfterReply, type AfterReplyContext } from './replay-after-reply.ts';

/** One subscription or unsubscription of a request; returns the topics whose retained record is to be sent. */
type Step = () => readonly TopicEntry[] | void;

type Context = AfterReplyContext & Pick<Core, 'clients' | 'limitWatch'>;

/** Subscribes and unsubscribes. [SV-12] */
export const topicSubscription = definer<keyof Context>()('topicSubscription', {
  roles: JOINED,
  subject: ({ clientId }) => clientId,
  async handle(core, message, call) {
    const client = core.clients.require(message.clientId, 'topic_subscription.client_id');
    const rateHz = rateOf(message);
    const replays: TopicEntry[] = [];
    try {
      for (const step of stepsOf(core, message, client.subscriber, rateHz)) {
        for (const entry of step() ?? []) replays.push(entry);
        const pause = call.yieldToEventLoop();
        if (pause !== undefined) await pause;
        if (client.status === 'removed') break;
      }
    } finally {
      // Subscriptions made before a failure stay, and receive their retained records.
      replayAfterReply(core, call, client, replays);
    }
    return success('Successfully processed all subscriptions.');
  },
});

/** Everything the request asks for, in the order in which it is done. */
function* stepsOf(
  core: Context,
  message: TopicSubscription,
  subscriber: Subscriber,
  rateHz: number,
): Iterable<Step> {
  const table = core.subscriptions;
  const { subscribeTopics, unsubscribeTopics } = message;
  const { subscribeTopicRegexp, unsubscribeTopicRegexp } = message;
  const { subscribeComponents, unsubscribeComponents } = message;
  for (const topic of requireElements(core, subscribeTopics)) {
    yield () => table.subscribeTopic(subscriber, topic, rateHz);
  }
  for (const topic of requireElements(core, unsubscribeTopics)) {
    yield () => table.unsubscribeTopic(subscriber, topic);
  }
  for (const source of requireElements(core, subscribeTopicRegexp)) {
    yield () => table.subscribePattern(subscriber, source, rateHz);
  }
  for (const source of requireElements(core, unsubscribeTopicRegexp)) {
    yield () => table.unsubscribePattern(subscriber, source);
  }
  for (const profile of requireElements(core, subscribeComponents)) {
    yield () => table.subscribeComponents(subscriber, profile, rateHz);
  }
  for (const profile of requireElements(core, unsubscribeComponents)) {
    yield () => table.unsubscribeComponents(subscriber, profile);
  }
}

/** Records per second and topic [TD-28]; 0 for every record. */
function rateOf({ maxRateHz }: TopicSubscription): number {
  if (maxRateHz >= 0) return Number.isFinite(maxRateHz) ? maxRateHz : 0;
  throw new ServiceError(
    'invalid_argument',
    `The member max_rate_hz is ${maxRateHz}, but a rate is 0 for every record or a positive number.`,
  );
}
