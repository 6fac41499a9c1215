import type { Layout } from './layout.ts';

/** How many steps can be taken back. */
const MAX_STEPS = 100;

/** What a layout was, step by step. */
export interface LayoutSteps {
  readonly past: readonly Layout[];
  readonly present: Layout;
  readonly future: readonly Layout[];
}

export const firstStep = (present: Layout): LayoutSteps => ({ past: [], present, future: [] });

/** @param isSame continues with the step before, as every move of one drag does */
export function nextStep(
  { past, present, future }: LayoutSteps,
  next: Layout,
  isSame: boolean,
): LayoutSteps {
  if (next.root === present.root && next.name === present.name) return { past, present, future };
  if (isSame) return { past, present: next, future: [] };
  return { past: [...past, present].slice(-MAX_STEPS), present: next, future: [] };
}

export function undoStep(steps: LayoutSteps): LayoutSteps {
  const before = steps.past.at(-1);
  if (!before) return steps;
  return {
    past: steps.past.slice(0, -1),
    present: before,
    future: [steps.present, ...steps.future],
  };
}

export function redoStep(steps: LayoutSteps): LayoutSteps {
  const [after, ...rest] = steps.future;
  if (!after) return steps;
  return { past: [...steps.past, steps.present], present: after, future: rest };
}
