import { useConnection } from '../../connection/useConnection.ts';
import { useNamedTopic } from '../../connection/useNamedTopic.ts';
import { useTopicParts } from '../../connection/useTopicParts.ts';
import type { ModuleLibrary } from '../../modules/library/useModuleLibrary.ts';
import { isInternalTopic } from '../../topics/names/internal-topics.ts';
import type { AddableSources } from '../canvas/addable.ts';
import type { KnownTopic } from '../model/fit/node-offer.ts';
import type { FindTopicsElsewhere } from '../model/commands/topics-elsewhere.ts';
import { phoneTopics } from '../live/phone-topics.ts';
import { useDeviceTopics } from '../live/useDeviceTopics.ts';

/**
 * Modules and topics to choose from: topics of this browser first, topics of unknown data format last. On a phone,
 * includes the topics of its smart device also while that page is closed: a phone has only one page open.
 * @param elsewhere returns the topics that others use
 */
export function useAddableSources(
  library: ModuleLibrary,
  elsewhere: FindTopicsElsewhere,
): AddableSources {
  const { client, topics } = useConnection();
  const deviceTopics = useDeviceTopics();
  const reader = useTopicParts();
  // Evaluated when a menu opens: rates change four times a second and must not cause a redraw.
  return {
    nameTopic: useNamedTopic(),
    get modules() {
      return (library.entries.value ?? []).map(({ module }) => module);
    },
    get used() {
      return elsewhere().used;
    },
    get topics() {
      const announced = new Set(deviceTopics.value.map(({ topic }) => topic));
      const published = [...(topics.rates.value?.values() ?? [])]
        .filter(({ statistic: { topic } }) => !isInternalTopic(topic) && !announced.has(topic))
        .map(({ statistic }) => ({ topic: statistic.topic, format: statistic.dataFormat }));
      const there = [...published, ...deviceTopics.value];
      const known = new Set(there.filter(({ format }) => format !== '').map(({ topic }) => topic));
      const absent = (reader.isPhone ? phoneTopics(client.id) : []).filter(
        ({ topic }) => !known.has(topic),
      );
      const replaced = new Set(absent.map(({ topic }) => topic));
      const rank = ({ topic, format }: KnownTopic): number =>
        (format === '' ? 2 : 0) + (reader.parts(topic).isOwn ? 0 : 1);
      return [...there.filter(({ topic }) => !replaced.has(topic)), ...absent].sort(
        (a, b) => rank(a) - rank(b),
      );
    },
  };
}
