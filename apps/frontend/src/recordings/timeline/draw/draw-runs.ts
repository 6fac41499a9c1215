import { xOf } from '../span.ts';
import type { Run } from '../run-log.ts';
import type { Pen, TrackInk, TrackView } from './track-canvas.ts';

/** Narrower bars have no room for a letter, pixels. */
const MIN_TEXT_PX = 18;
const TEXT_PADDING = 5;

/** How bars of a track look. */
export interface RunLook {
  readonly family: string;
  /** Texts that are the usual state and stand back. */
  readonly quiet: ReadonlySet<string>;
  readonly lanes: number;
  readonly hasText: boolean;
}

/** The text that held for most of the time, when others are to be seen beside it. */
export function quietLabels(runs: readonly Run[]): ReadonlySet<string> {
  const times = new Map<string, number>();
  for (const { label, fromMs, untilMs } of runs)
    times.set(label, (times.get(label) ?? 0) + untilMs - fromMs);
  if (times.size < 3) return new Set();
  const total = [...times.values()].reduce((sum, one) => sum + one, 0);
  const [label, ms] = [...times].reduce((most, one) => (one[1] > most[1] ? one : most));
  return ms > total * 0.4 ? new Set([label]) : new Set();
}

/** Draws a bar for each run, with its label where it fits. */
export function drawRuns(
  pen: Pen,
  runs: readonly Run[],
  view: TrackView,
  look: RunLook,
  ink: TrackInk,
): void {
  const { span, widthPx, heightPx } = view;
  const laneHeight = (heightPx - 6) / look.lanes;
  const barHeight = Math.min(20, laneHeight - 2);
  const fill = ink.color(`var(--family-${look.family})`);
  pen.font = ink.font;
  pen.textBaseline = 'middle';
  for (const run of runs) {
    if (run.untilMs < span.fromMs || run.fromMs > span.untilMs) continue;
    const x = Math.max(-8, xOf(run.fromMs, span, widthPx));
    const end = Math.min(widthPx + 8, xOf(run.untilMs, span, widthPx));
    const width = Math.max(1.5, end - x - 1);
    const y = 3 + run.lane * laneHeight + (laneHeight - barHeight) / 2;
    const isQuiet = look.quiet.has(run.label);
    pen.fillStyle = isQuiet ? ink.color('var(--s4)') : fill;
    pen.globalAlpha = run.lane % 2 === 1 ? 0.55 : 0.92;
    if (isQuiet) pen.globalAlpha = 0.6;
    pen.beginPath();
    pen.roundRect(x, y, width, barHeight, Math.min(2, width / 2));
    pen.fill();
    pen.globalAlpha = 1;
    if (look.hasText && width >= MIN_TEXT_PX && barHeight >= 9) {
      pen.fillStyle = ink.color(isQuiet ? 'var(--ink-2)' : 'var(--inv)');
      drawLabel(pen, run.label, {
        x: Math.max(0, x),
        y,
        width: end - Math.max(0, x),
        height: barHeight,
      });
    }
  }
}

interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

function drawLabel(pen: Pen, text: string, { x, y, width, height }: Box): void {
  pen.save();
  pen.beginPath();
  pen.rect(x, y, Math.max(0, width - 2), height);
  pen.clip();
  pen.fillText(text, x + TEXT_PADDING, y + height / 2 + 0.5);
  pen.restore();
}
