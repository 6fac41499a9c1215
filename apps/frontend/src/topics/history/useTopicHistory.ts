import { useRafFn } from '@vueuse/core';
import {
  computed,
  onScopeDispose,
  shallowRef,
  watch,
  type ComputedRef,
  type Ref,
  type ShallowRef,
} from 'vue';
import type { TopicRecord } from '@ubii/proto';
import { nowMs, TopicFeed } from './topic-feeds.ts';
import { TopicHistory } from './topic-history.ts';
import { useFeedPorts } from './useTopicFeeds.ts';

export { nowMs };

/** How often what is read is renewed, Hz; plots draw themselves in every frame. */
const READ_HZ = 8;

/** What readers see of a history at one moment. */
export interface HistoryView {
  readonly latest: TopicRecord | undefined;
  /** Records since the topic was opened: the newest that is shown has this number. */
  readonly count: number;
}

export const NOTHING_YET: HistoryView = { latest: undefined, count: 0 };

/**
 * Looks at a history a few times a second, unless paused.
 * @returns what is shown, and how many records have come
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
    if (isPaused.value && shown.value.count > 0) return;
    if (records !== shown.value.count) shown.value = { latest, count: records };
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
  const { pause } = useRafFn(read, { fpsLimit: READ_HZ });
  onScopeDispose(pause);
  return { shown, count };
}

/** Every record of one topic from now on, while the calling component lives. */
export function useTopicHistory(
  topic: Readonly<Ref<string>>,
  isPaused: Readonly<Ref<boolean>>,
): {
  history: Readonly<ShallowRef<TopicHistory>>;
  shown: Readonly<ShallowRef<HistoryView>>;
  /** Records that came since the view was paused. */
  waiting: ComputedRef<number>;
  /** The moment a paused view stands still at, this machine's clock; `undefined` while it runs. */
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
