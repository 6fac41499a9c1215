import { computed } from 'vue';
import { formatLook } from '../../formats/families.ts';
import type { FindPublisher } from '../names/publisher.ts';
import { rowView } from '../rows/row-view.ts';
import type { RowValue } from '../rows/row-value.ts';
import type { TopicNode } from '../tree/topic-node.ts';
import { siblingNames } from './sibling-names.ts';

/** What every row of a tree of topics is given. */
export interface TopicRowProps {
  /** Renewed in place; `tick` says when to look again. */
  readonly node: TopicNode;
  readonly value: RowValue | undefined;
  readonly findPublisher: FindPublisher;
  /** Milliseconds since the Unix epoch, master's clock. */
  readonly nowMs: number;
  readonly tick: number;
  readonly expanded: boolean;
}

/** What a row of a tree of topics shows: a client, a branch or a topic, with what it does now. */
export function useTopicRow(props: TopicRowProps) {
  /** A topic that lost its value keeps the socket it had. */
  let lastFormat = '';
  const onTick = <T>(look: (props: TopicRowProps) => T) =>
    computed(() => {
      void props.tick;
      return look(props);
    });
  const view = onTick(({ node, findPublisher, nowMs }) => rowView(node, findPublisher, nowMs));
  const siblings = onTick(({ node, findPublisher }) => siblingNames(node, findPublisher));
  const shown = onTick(({ node, value }) => {
    if (node.rate) lastFormat = node.rate.statistic.dataFormat || lastFormat;
    const { text, family } = formatLook(lastFormat);
    return {
      text: node.hasValue ? value?.text : undefined,
      /** `undefined` for a branch alone. */
      topic: node.rate?.statistic.topic,
      format: text || 'no value',
      family: node.rate ? family : ('system' as const),
      hasValue: node.hasValue,
      isBranch: node.isBranch,
      count: node.count,
    };
  });
  const isAway = computed(() => view.value.publisher?.isAway === true);
  return { view, siblings, shown, isAway };
}

export type TopicRowState = ReturnType<typeof useTopicRow>;
