import { useRafFn } from '@vueuse/core';
import { onScopeDispose, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { parseDataFormat, DATA_FORMATS, type TopicRecord } from '@ubii/proto';
import { useTopic } from '../../connection/live/useTopic.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { LastValues, type PassedValue } from './last-values.ts';

/** Rate at which the result is renewed, Hz. */
const READ_HZ = 6;
/** Highest rate of requested records, Hz; lower for pictures, which are large. */
const RATE_HZ = 60;
const PICTURE_HZ = 5;

/** Last values of a topic at one moment. */
export interface PassedView {
  /** Newest first. */
  readonly values: readonly PassedValue[];
  readonly line: readonly number[];
  /** Time of the snapshot, milliseconds of this computer's clock. */
  readonly nowMs: number;
  readonly newest: TopicRecord | undefined;
}

const NOTHING: PassedView = { values: [], line: [], nowMs: 0, newest: undefined };

/** Last values of a topic while the calling scope is active and the page is visible; no subscription otherwise. */
export function useLastValues(
  topic: Readonly<Ref<string | undefined>>,
): Readonly<ShallowRef<PassedView>> {
  const { topics } = useConnection();
  const view = shallowRef<PassedView>(NOTHING);
  let last = new LastValues();
  let newest: TopicRecord | undefined;

  function arrivedMs(isFirst: boolean): number {
    // The first record may be old: use the master's time for it.
    const publishedMs = isFirst
      ? (topics.rates.value?.get(topic.value ?? '')?.statistic.publishedMs ?? 0)
      : 0;
    const nowMs = Date.now();
    return publishedMs > 0 ? Math.min(nowMs, publishedMs - topics.clockOffsetMs.value) : nowMs;
  }

  watch(topic, () => {
    last = new LastValues();
    newest = undefined;
    view.value = NOTHING;
  });
  useTopic(topic, {
    keep: 0,
    maxRateHz() {
      const statistic = topics.rates.value?.get(topic.value ?? '')?.statistic;
      const format = parseDataFormat(statistic?.dataFormat ?? '');
      return format && DATA_FORMATS[format].family === 'image' ? PICTURE_HZ : RATE_HZ;
    },
    onRecord(record) {
      newest = record;
      last.add(record, arrivedMs(last.count === 0));
    },
  });
  const { pause } = useRafFn(
    () => {
      const nowMs = Date.now();
      if (last.count > 0)
        view.value = { values: last.values, line: last.line(nowMs), nowMs, newest };
    },
    { fpsLimit: READ_HZ },
  );
  onScopeDispose(pause);
  return view;
}
