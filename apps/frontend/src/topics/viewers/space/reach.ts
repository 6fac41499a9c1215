import type { SpaceThing } from './space-things.ts';

/** How far the ground reaches to each side, and how large a square of it is. */
export interface Ground {
  readonly reach: number;
  readonly step: number;
}

/** The smallest ground of round size that everything stands on: 1, 2, 5 times a power of ten, a half more. */
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

/** `0.5`, `20`: without the noise of halves and tens. */
export function formatStep(step: number): string {
  return String(Number(step.toPrecision(3)));
}
