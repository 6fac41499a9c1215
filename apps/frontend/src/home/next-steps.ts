import { useLocalStorage } from '@vueuse/core';
import { computed, type ComputedRef } from 'vue';
import { kindOf, useRecent, type RecentThing } from '../page/recent.ts';

/** Steps after the first touch, in their order. */
export const NEXT_STEPS = ['phone', 'module', 'example'] as const;
export type NextStep = (typeof NEXT_STEPS)[number];

/** Sessions and examples after which a person finds the way without steps. */
const MAX_OPENED = 3;
/** Step that is done when a thing of a kind was opened. */
const STEP_OF: Readonly<Record<string, NextStep>> = { session: 'module', example: 'example' };

/**
 * Returns the steps that Home still offers to a person who has only just begun.
 *
 * @param done steps that leave no thing behind, and dismissed ones
 */
export function stepsLeft(
  things: readonly Pick<RecentThing, 'id'>[],
  done: readonly string[],
): readonly NextStep[] {
  const opened = things.flatMap((one) => STEP_OF[kindOf(one)] ?? []);
  if (opened.length > MAX_OPENED) return [];
  return NEXT_STEPS.filter((step) => !opened.includes(step) && !done.includes(step));
}

/** The steps that are left in this browser. */
export function useNextSteps(): {
  readonly left: ComputedRef<readonly NextStep[]>;
  finish(...steps: readonly NextStep[]): void;
} {
  const done = useLocalStorage<readonly string[]>('ubii.stepsDone', []);
  const { things } = useRecent();
  return {
    left: computed(() => stepsLeft(things.value, done.value)),
    finish: (...steps) => (done.value = [...new Set([...done.value, ...steps])]),
  };
}
