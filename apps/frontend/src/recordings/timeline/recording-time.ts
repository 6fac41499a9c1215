const SECOND_MS = 1000;
const MINUTE_MS = 60 * SECOND_MS;
const HOUR_MS = 60 * MINUTE_MS;

const two = (value: number): string => String(value).padStart(2, '0');

/** A moment of a recording, or its length: `4:18`, `1:04:18`. */
export function formatLength(timeMs: number): string {
  const ms = Math.max(0, timeMs);
  const minutes = Math.floor((ms % HOUR_MS) / MINUTE_MS);
  const seconds = two(Math.floor((ms % MINUTE_MS) / SECOND_MS));
  const hours = Math.floor(ms / HOUR_MS);
  return hours > 0 ? `${hours}:${two(minutes)}:${seconds}` : `${minutes}:${seconds}`;
}

/** The same to the millisecond: `4:18.318`. */
export function formatPlace(timeMs: number): string {
  const ms = Math.round(Math.max(0, timeMs));
  return `${formatLength(ms)}.${String(ms % SECOND_MS).padStart(3, '0')}`;
}

/** Distances between lines of the ruler, milliseconds. */
const STEPS_MS = [
  ...[1, 2, 5, 10, 20, 50, 100, 200, 500],
  ...[1, 2, 4, 10, 20, 30].map((seconds) => seconds * SECOND_MS),
  ...[1, 2, 5, 10, 20, 30].map((minutes) => minutes * MINUTE_MS),
  ...[1, 2, 4, 12, 24].map((hours) => hours * HOUR_MS),
];

export interface RulerTick {
  readonly timeMs: number;
  /** Undefined for lines between those that are named. */
  readonly text: string | undefined;
}

/** Lines of the ruler at round moments. @param minPx between two that are named */
export function rulerTicks(
  span: { readonly fromMs: number; readonly untilMs: number },
  widthPx: number,
  minPx = 84,
): RulerTick[] {
  const msPerPx = (span.untilMs - span.fromMs) / Math.max(1, widthPx);
  const stepMs = STEPS_MS.find((step) => step >= msPerPx * minPx) ?? STEPS_MS.at(-1)!;
  const halfMs = stepMs / 2;
  const ticks: RulerTick[] = [];
  for (let index = Math.ceil(span.fromMs / halfMs); index * halfMs <= span.untilMs; index++) {
    const timeMs = index * halfMs;
    const isNamed = index % 2 === 0;
    ticks.push({ timeMs, text: isNamed ? tickText(timeMs, stepMs) : undefined });
  }
  return ticks;
}

const tickText = (timeMs: number, stepMs: number): string =>
  stepMs < SECOND_MS ? formatPlace(timeMs) : formatLength(timeMs);
