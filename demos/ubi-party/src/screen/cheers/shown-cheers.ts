import type { Cheer } from '../../sim/index.ts';

export interface ShownCheer extends Cheer {
  /** Of each cheer its own. */
  readonly id: number;
  readonly untilMs: number;
}

const SHOWN_MS = 2500;
/** More reach over what stands below a question. */
const MAX_SHOWN = 3;

/** Adds a cheer, the newest first: of each person the newest one, and no more than fit. */
export function addCheer(
  shown: readonly ShownCheer[],
  cheer: Cheer,
  id: number,
  nowMs: number,
): readonly ShownCheer[] {
  const others = stillShown(shown, nowMs).filter(({ key }) => key !== cheer.key);
  return [{ ...cheer, id, untilMs: nowMs + SHOWN_MS }, ...others].slice(0, MAX_SHOWN);
}

export function stillShown(shown: readonly ShownCheer[], nowMs: number): readonly ShownCheer[] {
  return shown.every(({ untilMs }) => untilMs > nowMs)
    ? shown
    : shown.filter(({ untilMs }) => untilMs > nowMs);
}
