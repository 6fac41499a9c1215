import { computed, shallowRef, watch, type ComputedRef, type Ref, type ShallowRef } from 'vue';
import type { TopicRecord } from '@ubii/proto';
import { nowMs, usePageReadings } from './page-clock.ts';
import { TopicFeed } from './topic-feeds.ts';
import { TopicHistory } from './topic-history.ts';
import { useFeedPorts } from './useTopicFeeds.ts';

/** Snapshot of a history. */
export interface HistoryView {
  readonly latest: TopicRecord | undefined;
  /** Number of the newest record shown, counted since the topic was opened. */
  readonly count: number;
}

export const NOTHING_YET: HistoryView = { latest: undefined, count: 0 };

/**
 * Samples a history a few times a second, unless paused.
 * @returns the snapshot, and the number of records received
 */
export function useHistoryView(
  history: Readonly<Ref<TopicHistory>>,
  isPaused: Readonly<Ref<boolean>>,
): { shown: Readonly<ShallowRef<HistoryView>>; count: Readonly<ShallowRef<number>> } {
  const shown = shallowRef<HistoryView>(NOTHING_YET);
  const count = shallowRef(0);
  function read(): void {
    const { latest, count: records } = history.value;
    count.value = records;
    const before = shown.value;
    if (isPaused.value && before.latest !== undefined) return;
    // Records that came before the page do not count, and the newest may be one of them.
    if (records !== before.count || latest !== before.latest) {
      shown.value = { latest, count: records };
    }
  }
  watch(
    history,
    () => {
      shown.value = NOTHING_YET;
      read();
    },
    { immediate: true, flush: 'sync' },
  );
  watch(isPaused, read);
  usePageReadings(read);
  return { shown, count };
}

/** Records the topic from now on, while the calling component is mounted. */
export function useTopicHistory(
  topic: Readonly<Ref<string>>,
  isPaused: Readonly<Ref<boolean>>,
): {
  history: Readonly<ShallowRef<TopicHistory>>;
  shown: Readonly<ShallowRef<HistoryView>>;
  /** Number of records received since the view was paused. */
  waiting: ComputedRef<number>;
  /** Time at which a paused view stopped, this computer's clock; `undefined` while it runs. */
  frozenMs: Readonly<ShallowRef<number | undefined>>;
} {
  const ports = useFeedPorts();
  const history = shallowRef(new TopicHistory());
  const frozenMs = shallowRef<number>();
  const { shown, count } = useHistoryView(history, isPaused);

  watch(
    [topic, () => ports.limits],
    ([name], _before, onCleanup) => {
      const feed = new TopicFeed(name, ports);
      history.value = feed.history;
      if (isPaused.value) frozenMs.value = nowMs();
      onCleanup(feed.look());
    },
    { immediate: true },
  );
  watch(isPaused, (paused) => (frozenMs.value = paused ? nowMs() : undefined), {
    immediate: true,
  });

  return {
    history,
    shown,
    waiting: computed(() => (isPaused.value ? count.value - shown.value.count : 0)),
    frozenMs,
  };
}
