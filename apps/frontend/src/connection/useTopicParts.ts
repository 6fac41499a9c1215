import { useMediaQuery } from '@vueuse/core';
import { computed } from 'vue';
import { topicParts, type TopicParts } from './topic-parts.ts';
import { useConnection } from './useConnection.ts';

/** Topics as lists of phones show them. */
export interface TopicReader {
  parts(topic: string): TopicParts;
  /** What is at the end, and whose it is: `touch_position · this phone`. */
  short(topic: string): string;
  /** Whose the topics of this browser are: `this phone`. */
  readonly self: string;
  /** It is a phone. */
  readonly isPhone: boolean;
}

export function useTopicParts(): TopicReader {
  const { client, clients, isConnected } = useConnection();
  const isPhone = useMediaQuery('(pointer: coarse) and (max-width: 759px)');
  const self = computed(() => (isPhone.value ? 'this phone' : 'this browser'));
  function parts(topic: string): TopicParts {
    void clients.list.value;
    void isConnected.value;
    return topicParts(topic, client.id, (id) => clients.find(id)?.name);
  }
  return {
    parts,
    short(topic) {
      const { name, owner, isOwn } = parts(topic);
      const whose = isOwn ? self.value : owner;
      return whose === undefined ? topic : `${name} · ${whose}`;
    },
    get isPhone() {
      return isPhone.value;
    },
    get self() {
      return self.value;
    },
  };
}
