import {
  effectScope,
  onScopeDispose,
  shallowRef,
  watch,
  type EffectScope,
  type Ref,
  type ShallowRef,
} from 'vue';
import type { TopicChanges, TopicRate } from '../../connection/topic-rates.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { isInternalTopic } from '../names/internal-topics.ts';
import { nameOf } from '../rows/row-view.ts';
import type { RowValues } from '../rows/row-values.ts';
import { usePageReadings } from '../history/page-clock.ts';
import { useRowValues } from '../rows/useRowValues.ts';
import type { FindPublisher } from '../names/publisher.ts';
import { parseTopicFilter } from '../tree/topic-filter.ts';
import type { TopicNode } from '../tree/topic-node.ts';
import type { TopicOrder } from '../tree/topic-order.ts';
import { TopicsModel } from '../tree/topics-model.ts';
import { useFindPublisher } from '../names/useFindPublisher.ts';

/** Interval of requests for the statistics of all topics, milliseconds. */
const STATISTICS_MS = 250;

/** Search and order; set by the page. */
export interface TopicTreeWishes {
  readonly search: Ref<string>;
  /** Short name of a data format; empty for all. */
  readonly format: Ref<string>;
  readonly order: Ref<TopicOrder>;
  /** Freezes the rows. Statistics are totals, so nothing is lost. */
  readonly isPaused: Ref<boolean>;
  /** Whether a topic is in the tree; internal topics never are. @default all */
  readonly accepts?: (topic: string) => boolean;
}

/** The topic tree, live. */
export interface TopicTreeView {
  /** Mutated in place; `tick` signals changes. */
  readonly model: TopicsModel;
  readonly values: RowValues;
  readonly findPublisher: FindPublisher;
  readonly rows: Readonly<ShallowRef<readonly TopicNode[]>>;
  /** Incremented whenever rows must be drawn, with the readings of the page. */
  readonly tick: Readonly<ShallowRef<number>>;
  /** Time of the displayed state, epoch milliseconds of the master's clock. */
  readonly nowMs: Readonly<ShallowRef<number>>;
  /** Name of a row. */
  nameOf(node: TopicNode): string;
  setExpanded(node: TopicNode, expanded: boolean): void;
  expandSiblings(node: TopicNode): void;
  setAllExpanded(expanded: boolean): void;
  /** Expands the branches above a topic. */
  reveal(topic: string): void;
}

/** Feeds the model with the master's statistics, and draws it a few times a second while the page is visible. */
export function useTopicTree({
  search,
  format,
  order,
  isPaused,
  accepts = () => true,
}: TopicTreeWishes): TopicTreeView {
  const { clients, topics, isConnected } = useConnection();
  const findPublisher = useFindPublisher();
  const model = new TopicsModel(findPublisher);
  const values = useRowValues();
  const rows = shallowRef<readonly TopicNode[]>([]);
  const tick = shallowRef(0);
  const nowMs = shallowRef(0);
  let isStatisticsNew = true;

  function draw(): void {
    // While the master is disconnected, rates are unknown and do not change the order.
    model.refresh(isConnected.value ? performance.now() : -Infinity);
    nowMs.value = topics.masterTimeMs.value;
    rows.value = model.rows;
    tick.value += 1;
  }

  const accepted = ({ statistic: { topic } }: TopicRate): boolean =>
    !isInternalTopic(topic) && accepts(topic);
  const waiting: TopicChanges[] = [];
  topics.onChanges(({ added, removed }) => {
    const changes = { added: added.filter(accepted), removed: removed.filter(accepted) };
    if (isPaused.value) waiting.push(changes);
    else model.apply(changes);
  });
  watch(
    topics.rates,
    () => {
      isStatisticsNew = true;
      // Rates became unknown, and no statistics arrive that would cause a draw.
      if (!isConnected.value && !isPaused.value) draw();
    },
    { flush: 'sync' },
  );
  model.apply({ added: [...(topics.rates.value?.values() ?? [])].filter(accepted), removed: [] });

  usePageReadings((readMs) => {
    if (isPaused.value || !isConnected.value) {
      if (values.takeFirst()) tick.value += 1;
      return;
    }
    values.sample(readMs);
    if (isStatisticsNew) {
      isStatisticsNew = false;
      draw();
    } else {
      tick.value += 1;
    }
  });

  let asking: EffectScope | undefined;
  watch(
    isPaused,
    (paused) => {
      values.setPaused(paused);
      if (paused) {
        asking?.stop();
        return;
      }
      for (const changes of waiting.splice(0)) model.apply(changes);
      asking = effectScope();
      asking.run(() => topics.watch(STATISTICS_MS));
    },
    { immediate: true },
  );
  watch(clients.list, () => {
    model.handlePublishers();
    if (!isPaused.value) draw();
  });

  // The user's changes are shown at once, also while paused.
  watch(
    search,
    (text) => {
      model.setFilter(parseTopicFilter(text));
      draw();
    },
    { immediate: true },
  );
  watch(
    format,
    (name) => {
      model.setFormat(name === '' ? undefined : name);
      draw();
    },
    { immediate: true },
  );
  watch(
    order,
    (next) => {
      model.setOrder(next);
      draw();
    },
    { immediate: true },
  );

  onScopeDispose(() => asking?.stop());

  function setExpanded(node: TopicNode, expanded: boolean): void {
    model.setExpanded(node, expanded);
    draw();
  }

  return {
    model,
    values,
    findPublisher,
    rows,
    tick,
    nowMs,
    nameOf: (node) => nameOf(node, findPublisher),
    setExpanded,
    expandSiblings(node) {
      for (const sibling of node.parent?.children.values() ?? []) model.setExpanded(sibling, true);
      draw();
    },
    setAllExpanded(expanded) {
      model.setAllExpanded(expanded);
      draw();
    },
    reveal(topic) {
      model.reveal(topic);
      draw();
    },
  };
}
