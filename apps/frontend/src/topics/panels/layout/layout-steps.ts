import type { Layout } from './layout.ts';

/** Most undo steps. */
const MAX_STEPS = 100;

/** A layout with its undo history. */
export interface LayoutSteps {
  readonly past: readonly Layout[];
  readonly present: Layout;
  readonly future: readonly Layout[];
}

export const firstStep = (present: Layout): LayoutSteps => ({ past: [], present, future: [] });

/** @param isSame extends the previous step, as for each movement of a drag */
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
