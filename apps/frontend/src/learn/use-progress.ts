import { useLocalStorage } from '@vueuse/core';
import type { Ref } from 'vue';
import { parseProgress, PROGRESS_KEY, type Progress } from './model/progress.ts';

/** How far this browser has come in each lesson; assign to change it. */
export function useProgress(): Ref<Progress> {
  return useLocalStorage<Progress>(
    PROGRESS_KEY,
    {},
    { serializer: { read: parseProgress, write: (progress) => JSON.stringify(progress) } },
  );
}
