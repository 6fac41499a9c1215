import { useMediaQuery } from '@vueuse/core';
import { computed } from 'vue';
import { topicParts, type TopicParts } from './topic-parts.ts';
import { useConnection } from './useConnection.ts';

/** Formats topics for lists on phones. */
export interface TopicReader {
  parts(topic: string): TopicParts;
  /** Last part and client: `touch_position · this phone`. */
  short(topic: string): string;
  /** Name of this browser as owner of topics: `this phone`. */
  readonly self: string;
  /** True on phones. */
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
