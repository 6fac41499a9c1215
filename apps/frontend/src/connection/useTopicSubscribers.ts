import { ServiceError, type TopicSubscribers } from '@ubii/proto';
import { computed, shallowRef, watch, type ShallowRef } from 'vue';
import { usePoll } from './poll.ts';
import { tryRequest } from './useAttempt.ts';
import { useConnection } from './useConnection.ts';

/** Interval of requests, milliseconds. */
const INTERVAL_MS = 1000;

/** Current subscribers of a topic; `undefined` without a topic, and on masters that do not report them. [EX-95] */
export function useTopicSubscribers(
  topic: () => string | undefined,
): Readonly<ShallowRef<TopicSubscribers | undefined>> {
  const { client, isConnected } = useConnection();
  const subscribers = shallowRef<TopicSubscribers>();

  async function ask(): Promise<void> {
    const asked = topic();
    if (asked === undefined) return;
    const reply = await tryRequest(
      () => client.call('topicSubscribers', { topics: [asked] }),
      (cause) => {
        if (cause instanceof ServiceError) subscribers.value = undefined;
      },
    );
    if (reply && topic() === asked) subscribers.value = reply.elements[0];
  }
  watch(topic, () => (subscribers.value = undefined));
  usePoll(
    ask,
    INTERVAL_MS,
    computed(() => isConnected.value && topic() !== undefined),
  );
  return subscribers;
}
