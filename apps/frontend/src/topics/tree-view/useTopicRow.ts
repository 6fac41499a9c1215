import { computed } from 'vue';
import { formatLook } from '../../formats/families.ts';
import type { FindPublisher } from '../names/publisher.ts';
import { rowView } from '../rows/row-view.ts';
import type { RowValue } from '../rows/row-value.ts';
import type { TopicNode } from '../tree/topic-node.ts';

/** Properties of every row of a topic tree. */
export interface TopicRowProps {
  /** Mutated in place; `tick` signals changes. */
  readonly node: TopicNode;
  readonly value: RowValue | undefined;
  readonly findPublisher: FindPublisher;
  /** Epoch milliseconds, master's clock. */
  readonly nowMs: number;
  readonly tick: number;
  readonly expanded: boolean;
}

/** State of a row of a topic tree: a client, a branch or a topic. */
export function useTopicRow(props: TopicRowProps) {
  /** A topic without a value keeps the socket of its last format. */
  let lastFormat = '';
  const onTick = <T>(look: (props: TopicRowProps) => T) =>
    computed(() => {
      void props.tick;
      return look(props);
    });
  const view = onTick(({ node, findPublisher, nowMs }) => rowView(node, findPublisher, nowMs));
  const shown = onTick(({ node, value }) => {
    if (node.rate) lastFormat = node.rate.statistic.dataFormat || lastFormat;
    const { text, family } = formatLook(lastFormat);
    return {
      text: node.hasValue ? value?.text : undefined,
      /** `undefined` for a branch that is not a topic. */
      topic: node.rate?.statistic.topic,
      format: text || 'no value',
      family: node.rate ? family : ('system' as const),
      hasValue: node.hasValue,
      /** Id of the client, of a branch that is one. */
      label: node.label,
      isBranch: node.isBranch,
      count: node.count,
    };
  });
  const isAway = computed(() => view.value.publisher?.isAway === true);
  return { view, shown, isAway };
}

export type TopicRowState = ReturnType<typeof useTopicRow>;
