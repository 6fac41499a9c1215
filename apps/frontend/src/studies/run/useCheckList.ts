import type { StudyCheckList } from '@ubii/proto';
import { useDocumentVisibility, useIntervalFn } from '@vueuse/core';
import { computed, watch, type ComputedRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { useStudies } from '../useStudies.ts';

/** The master publishes a check list for ten seconds after each request. [ST-32] */
const ASK_MS = 5000;

/** The required devices of a study as they are now, while the page is visible. */
export function useCheckList(studyId: () => string): ComputedRef<StudyCheckList | undefined> {
  const studies = useStudies();
  const { isConnected } = useConnection();
  const visibility = useDocumentVisibility();
  const ask = (): void => {
    if (isConnected.value && visibility.value === 'visible') void studies.check(studyId());
  };
  useIntervalFn(ask, ASK_MS);
  watch([studyId, isConnected, visibility], ask, { immediate: true });
  return computed(() =>
    studies.status.value?.checkLists.find((list) => list.studyId === studyId()),
  );
}
