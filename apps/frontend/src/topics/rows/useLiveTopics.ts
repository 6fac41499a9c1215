import { effectScope, onScopeDispose, shallowRef, watch, type EffectScope } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { usePageReadings } from '../history/page-clock.ts';
import { useRowValues } from './useRowValues.ts';

/** Interval of requests for statistics while topics are visible, milliseconds. */
const STATISTICS_MS = 1000;

/** Current state of a topic. */
export interface LiveTopic {
  /** Newest value in one line; `undefined` without one. */
  readonly text: string | undefined;
  /** Records per second; `undefined` while unknown. */
  readonly hz: number | undefined;
}

/**
 * Newest values of the visible topics, while the calling component is mounted.
 * @param wanted the topics; read reactively
 */
export function useLiveTopics(wanted: () => readonly string[]): (topic: string) => LiveTopic {
  const { topics, isConnected } = useConnection();
  const values = useRowValues();
  const tick = shallowRef(0);
  const rateOf = (topic: string) => topics.rates.value?.get(topic);

  let asking: EffectScope | undefined;
  watch(
    () => wanted().length > 0,
    (isWanted) => {
      asking?.stop();
      asking = undefined;
      if (!isWanted) return;
      asking = effectScope();
      asking.run(() => topics.watch(STATISTICS_MS));
    },
    { immediate: true },
  );
  watch([() => wanted().join('\n'), topics.rates], () => values.showNamed(wanted(), rateOf), {
    immediate: true,
  });
  usePageReadings((readMs) => {
    if (!isConnected.value || wanted().length === 0) return;
    values.sample(readMs);
    tick.value += 1;
  });
  onScopeDispose(() => asking?.stop());

  return (topic) => {
    void tick.value;
    return { text: values.get(topic)?.text, hz: rateOf(topic)?.hz };
  };
}
