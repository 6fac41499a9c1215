import { useLocalStorage } from '@vueuse/core';
import * as v from 'valibot';
import { computed, type ComputedRef } from 'vue';
import { storedAs } from '../../json/read-stored.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { useStudies } from '../useStudies.ts';

const MAX_LABELS = 6;
const FIRST: readonly string[] = ['Trial', 'Error', 'Question'];

/** Markers with a text, of the recording of the block that runs. Those without one are the shell's, by M. */
export interface RunMarkers {
  /** Texts that were used last in this study, in this browser. */
  readonly labels: ComputedRef<readonly string[]>;
  add(text: string): Promise<void>;
}

/** @param recordingId empty while no block runs */
export function useMarkers(studyId: () => string, recordingId: () => string): RunMarkers {
  const studies = useStudies();
  const toasts = useToasts();
  const stored = useLocalStorage<readonly string[]>(`ubii.studyMarkers.${studyId()}`, FIRST, {
    serializer: storedAs(v.pipe(v.array(v.string()), v.readonly()), FIRST),
  });
  return {
    labels: computed(() => stored.value),
    async add(text) {
      if (recordingId() === '' || !(await studies.mark(recordingId(), text))) return;
      toasts.show(`Marker “${text}” added`, undefined, 'marker');
      if (!stored.value.includes(text)) stored.value = [text, ...stored.value].slice(0, MAX_LABELS);
    },
  };
}
