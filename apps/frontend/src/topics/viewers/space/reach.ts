import type { SpaceThing } from './space-things.ts';

/** Half the size of the ground, and the size of its squares. */
export interface Ground {
  readonly reach: number;
  readonly step: number;
}

/** Returns the smallest ground of round size (1, 2 or 5 times a power of ten) that contains everything. */
export function groundFor(things: readonly SpaceThing[]): Ground {
  let most = 0;
  for (const { at, axes, isToScale, size } of things) {
    const arms = isToScale ? Math.max(...(axes ?? []).map((axis) => Math.hypot(...axis)), 0) : 0;
    const half = size ? Math.hypot(...size) / 2 : 0;
    most = Math.max(most, Math.hypot(...at) + Math.max(arms, half));
  }
  if (!(most > 0) || !Number.isFinite(most)) most = 1;
  const power = 10 ** Math.floor(Math.log10(most));
  const reach = power * ([1, 2, 5, 10].find((factor) => factor * power >= most * 0.999) ?? 10);
  return { reach, step: reach / 5 };
}

/** Formats a step without artefacts of binary fractions: `0.5`, `20`. */
export function formatStep(step: number): string {
  return String(Number(step.toPrecision(3)));
}
