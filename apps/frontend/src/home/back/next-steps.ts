import { kindOf, type RecentThing } from '../../page/recent.ts';

/** Steps after the first touch, in their order. */
export const NEXT_STEPS = ['phone', 'module', 'example'] as const;
export type NextStep = (typeof NEXT_STEPS)[number];

/** Sessions and examples after which a person finds the way without steps. */
const MAX_OPENED = 3;
/** Step that is done when a thing of a kind was opened. */
const STEP_OF: Readonly<Record<string, NextStep>> = { session: 'module', example: 'example' };

/** Id of a step among the recent things: of one that opens nothing, or was dismissed. */
export const stepId = (step: NextStep): string => `step ${step}`;

/** Returns the steps that Home still offers to a person who has only just begun. */
export function stepsLeft(things: readonly Pick<RecentThing, 'id'>[]): readonly NextStep[] {
  const opened = things.flatMap((one) => STEP_OF[kindOf(one)] ?? []);
  if (opened.length > MAX_OPENED) return [];
  const ids = things.map(({ id }) => id);
  return NEXT_STEPS.filter((step) => !opened.includes(step) && !ids.includes(stepId(step)));
}
