import { useDocumentVisibility, useIntervalFn } from '@vueuse/core';
import { shallowRef, watch, type ShallowRef } from 'vue';

/** This computer's clock as a ref, epoch milliseconds, updated at an interval while the page is visible. */
export function useTick(intervalMs: number): Readonly<ShallowRef<number>> {
  const nowMs = shallowRef(Date.now());
  const visibility = useDocumentVisibility();
  const { pause, resume } = useIntervalFn(() => (nowMs.value = Date.now()), intervalMs, {
    immediateCallback: true,
  });
  watch(visibility, (next) => (next === 'visible' ? resume() : pause()));
  return nowMs;
}
