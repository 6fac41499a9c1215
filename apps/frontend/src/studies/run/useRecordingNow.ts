import { RECORDING_STATUS_TOPIC, type Recording } from '@ubii/proto';
import { computed, shallowRef, watch, type ComputedRef } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';

/** What is recorded now. */
export interface RecordingNow {
  readonly recording: Recording;
  /** Over the last second or so; undefined with the first news. */
  readonly recordsPerSecond: number | undefined;
}

/** @param id of the recording of the block that runs; empty for none */
export function useRecordingNow(id: () => string): ComputedRef<RecordingNow | undefined> {
  const { newest } = useTopic(RECORDING_STATUS_TOPIC, { format: 'recordingStatus' });
  const recording = computed(() => newest.value?.value.running.find((one) => one.id === id()));
  const rate = shallowRef<number>();
  watch(recording, (next, last) => {
    rate.value = next && last?.id === next.id ? (rateBetween(last, next) ?? rate.value) : undefined;
  });
  return computed(
    () => recording.value && { recording: recording.value, recordsPerSecond: rate.value },
  );
}

/** Undefined when no time passed between both. */
export function rateBetween(
  last: Pick<Recording, 'durationMs' | 'recordCount'>,
  next: Pick<Recording, 'durationMs' | 'recordCount'>,
): number | undefined {
  const ms = next.durationMs - last.durationMs;
  return ms > 0 ? ((next.recordCount - last.recordCount) / ms) * 1000 : undefined;
}
