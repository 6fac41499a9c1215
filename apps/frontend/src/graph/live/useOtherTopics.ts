import { formatsFit } from '@ubii/pm-sandbox';
import { isSameValue, parseDataFormat } from '@ubii/proto';
import { computed } from 'vue';
import { isClientId } from '../../connection/display-names.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { rootLabel } from '../../topics/names/topic-path.ts';
import { useFindPublisher } from '../../topics/names/useFindPublisher.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';
import { topicNodeId } from '../model/make-node.ts';
import { portOf } from '../model/port-format.ts';
import { wiresOf } from '../model/wires-of.ts';
import type { OtherTopic, OtherTopics } from './left-topic-advice.ts';

/** Finds replacements for a topic of the graph; using one is an undoable edit. */
export function useOtherTopics(editor: GraphEditor): (topic: string) => OtherTopics {
  const { client, clients, topics } = useConnection();
  const findPublisher = useFindPublisher();
  const present = computed(() => new Set(clients.list.value?.map(({ id }) => id)));
  /**
   * Topics of clients, those of this browser first. Statistics arrive continuously; recompute only for other topics.
   */
  const published = computed<readonly OtherTopic[]>((before) => {
    const all = [...(topics.rates.value?.values() ?? [])]
      .map(({ statistic }) => statistic)
      .filter(({ topic, publishedMs }) => publishedMs > 0 && isClientId(rootLabel(topic)))
      .map(({ topic, dataFormat: format }) => ({ topic, format }));
    const isOwn = ({ topic }: OtherTopic): boolean => rootLabel(topic) === client.id;
    const next = [...all.filter(isOwn), ...all.filter((one) => !isOwn(one))];
    return before !== undefined && isSameValue(before, next) ? before : next;
  });
  return (topic) => {
    const node = topicNodeId(topic);
    return {
      findPublisher,
      isPresent: (id) => present.value.has(id),
      topics: () => published.value,
      fits: (format) =>
        wiresOf(editor.graph.value, node).out.every(({ to }) =>
          formatsFit(parseDataFormat(format), portOf(editor.graph.value, to)?.format),
        ),
      use: (other) => editor.apply({ kind: 'renameTopic', node, topic: other }),
    };
  };
}
