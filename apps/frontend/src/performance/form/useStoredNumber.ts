import { useLocalStorage } from '@vueuse/core';
import { computed, reactive, ref } from 'vue';

/** A number of a form that this browser keeps. */
export interface StoredNumber {
  /** `undefined` while the text in its field is refused. */
  readonly value: number | undefined;
  /** Why the text in its field is refused, one sentence. */
  readonly error: string | undefined;
  /** Props and listeners of its `UiNumberField`. */
  readonly field: NumberFieldBinding;
}

/** What a `UiNumberField` takes. */
export interface NumberFieldBinding {
  readonly modelValue: number;
  readonly min: number;
  readonly max: number;
  readonly isWhole: boolean;
  readonly 'onUpdate:modelValue': (next: number) => void;
  readonly onRefuse: (reason: string | undefined) => void;
}

/** @param key of `localStorage` */
export function useStoredNumber(
  key: string,
  {
    initial,
    min,
    max,
    isWhole = true,
  }: {
    readonly initial: number;
    readonly min: number;
    readonly max: number;
    readonly isWhole?: boolean;
  },
): StoredNumber {
  const stored = useLocalStorage(`ubii.performance.${key}`, initial);
  const error = ref<string>();
  /** Versions before kept the text, whatever it was. */
  const number = computed(() =>
    stored.value >= min && stored.value <= max ? stored.value : initial,
  );
  return reactive({
    error,
    value: computed(() => (error.value === undefined ? number.value : undefined)),
    field: computed(() => ({
      modelValue: number.value,
      min,
      max,
      isWhole,
      'onUpdate:modelValue': (next: number) => (stored.value = next),
      onRefuse: (reason: string | undefined) => (error.value = reason),
    })),
  });
}
