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
import { useConnection } from '../../connection/useConnection.ts';
import { TopicHistory, type RecordLine } from './topic-history.ts';

/** How often what is read is renewed, Hz; plots draw themselves in every frame. */
const READ_HZ = 8;

/** What readers see of a history at one moment. */
export interface HistoryView {
  readonly latest: TopicRecord | undefined;
  /** Newest first. */
  readonly lines: readonly RecordLine[];
  /** Records since the topic was opened. */
  readonly count: number;
}

const NOTHING: HistoryView = { latest: undefined, lines: [], count: 0 };

/** Milliseconds since the Unix epoch, this machine's clock, with fractions and never going back. */
export const nowMs = (): number => performance.timeOrigin + performance.now();

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
  const { client, topics } = useConnection();
  const history = shallowRef(new TopicHistory());
  const shown = shallowRef<HistoryView>(NOTHING);
  const count = shallowRef(0);
  const frozenMs = shallowRef<number>();

  function read(): void {
    const { latest, count: records } = history.value;
    count.value = records;
    if (isPaused.value && shown.value.count > 0) return;
    if (records !== shown.value.count) {
      shown.value = { latest, lines: history.value.lines(), count: records };
    }
  }

  /** The first record may be a retained one: it came when the master says, not now. */
  function arrivalMs(record: TopicRecord, isFirst: boolean): number {
    const now = nowMs();
    if (!isFirst) return now;
    const publishedMs = topics.rates.value?.get(record.topic)?.statistic.publishedMs ?? 0;
    const cameMs = publishedMs > 0 ? publishedMs - topics.clockOffsetMs.value : record.timestampMs;
    return Math.min(now, cameMs ?? now);
  }

  watch(
    topic,
    (name, _before, onCleanup) => {
      const fresh = new TopicHistory();
      history.value = fresh;
      shown.value = NOTHING;
      count.value = 0;
      if (isPaused.value) frozenMs.value = nowMs();
      const subscription = client
        .subscribe(name)
        .onRecord((record) => fresh.add(record, arrivalMs(record, fresh.count === 0)));
      // Refused by the master: the client tells, and the page shows no value.
      subscription.ready.catch(() => undefined);
      onCleanup(() => void subscription.close());
    },
    { immediate: true },
  );
  watch(
    isPaused,
    (paused) => {
      frozenMs.value = paused ? nowMs() : undefined;
      read();
    },
    { immediate: true },
  );
  const { pause } = useRafFn(read, { fpsLimit: READ_HZ });
  onScopeDispose(pause);

  return {
    history,
    shown,
    waiting: computed(() => (isPaused.value ? count.value - shown.value.count : 0)),
    frozenMs,
  };
}
