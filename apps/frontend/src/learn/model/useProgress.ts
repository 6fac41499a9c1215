import { useLocalStorage } from '@vueuse/core';
import type { Ref } from 'vue';
import { PROGRESS_KEY, storedProgress, type Progress } from './progress.ts';

/** Progress of this browser in each lesson; assign to change it. */
export function useProgress(): Ref<Progress> {
  return useLocalStorage<Progress>(PROGRESS_KEY, {}, { serializer: storedProgress });
}
