import { computed, shallowRef, watch, type ComputedRef } from 'vue';

/**
 * Returns the reason why a topic that had a value has none.
 *
 * @param count number of records received
 * @param masterMs start time of the running master; `undefined` while unknown
 */
export function useEndedSentence(
  topic: () => string,
  count: () => number,
  masterMs: () => number | undefined,
): ComputedRef<string> {
  /** Start time of the master that sent the last record. */
  const sentByMs = shallowRef<number>();
  watch(
    [topic, count, masterMs] as const,
    ([name, seen, startedMs], [nameBefore, seenBefore]) => {
      const isNew = name !== nameBefore || seen !== seenBefore;
      if (isNew || sentByMs.value === undefined) sentByMs.value = startedMs;
    },
    { immediate: true },
  );
  return computed(() => {
    const isOther = sentByMs.value !== undefined && masterMs() !== sentByMs.value;
    const why = isOther
      ? 'The master was restarted. The topic has had no value since.'
      : 'The topic no longer has a value.';
    return `${why} Its last value is shown until you leave this page.`;
  });
}
