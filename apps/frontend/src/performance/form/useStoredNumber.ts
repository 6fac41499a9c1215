import { useLocalStorage } from '@vueuse/core';
import { computed, reactive } from 'vue';
import { formatNumber } from '../../ui/readouts/format-number.ts';

/** State of a number field: its text, its value, and its error. */
export interface NumberField {
  text: string;
  /** The number; `undefined` while there is an error. */
  readonly value: number | undefined;
  readonly error: string | undefined;
}

/**
 * Number field whose value is stored in this browser.
 * @param key of `localStorage`
 */
export function useNumber(
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
): NumberField {
  const text = useLocalStorage(`ubii.performance.${key}`, String(initial));
  const number = computed(() => {
    const trimmed = text.value.trim();
    return trimmed === '' ? NaN : Number(trimmed);
  });
  const error = computed(() => {
    const isFine = number.value >= min && number.value <= max;
    if (isFine && (!isWhole || Number.isInteger(number.value))) return undefined;
    const kind = isWhole ? 'a whole number' : 'a number';
    return `Enter ${kind} from ${formatNumber(min)} to ${formatNumber(max)}.`;
  });
  return reactive({
    text,
    error,
    value: computed(() => (error.value === undefined ? number.value : undefined)),
  });
}
