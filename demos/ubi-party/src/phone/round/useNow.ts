import { useRafFn } from '@vueuse/core';
import { shallowRef, type ShallowRef } from 'vue';
import { usePhone } from '../frame/phone-context.ts';

/** The master's clock, once per frame, milliseconds since the Unix epoch. */
export function useNow(): Readonly<ShallowRef<number>> {
  const { facts } = usePhone();
  const nowMs = shallowRef(facts.value.nowMs());
  useRafFn(() => (nowMs.value = facts.value.nowMs()));
  return nowMs;
}
