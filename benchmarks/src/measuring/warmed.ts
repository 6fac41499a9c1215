import type { Measurement, MeasureOptions, Subject } from './workload.ts';

/** The figure has to fall by this share for the subject to count as not yet warm. */
const GAIN = 0.05;
/** Measurements without such a gain, one after the other, after which the subject is warm. */
const STEADY_COUNT = 3;
const MAX_COUNT = 20;
const LONGEST_MS = 1_000;

/**
 * The same subject, warm: before its first measurement, it is measured again and again until a figure does not fall any
 * more. V8 compiles what runs often, which takes seconds at a few hundred calls a second.
 *
 * @param key of a figure that is better when it is lower
 */
export function warmed(subject: Subject, key: string): Subject {
  let warming: Promise<string[]> | undefined = undefined;
  return {
    ...subject,
    measure: async (options) => {
      const faults = await (warming ??= warmUp(subject, key, options));
      warming = Promise.resolve([]);
      const measurement = await subject.measure(options);
      return { ...measurement, faults: [...faults, ...measurement.faults] };
    },
  };
}

/** @returns what went wrong, each once: a record that is lost while it warms up is lost */
async function warmUp(subject: Subject, key: string, options: MeasureOptions): Promise<string[]> {
  const measureMs = Math.min(options.measureMs, LONGEST_MS);
  const faults = new Set<string>();
  let least = Number.POSITIVE_INFINITY;
  let steadyCount = 0;
  for (let count = 0; count < MAX_COUNT && steadyCount < STEADY_COUNT; count += 1) {
    const measurement: Measurement = await subject.measure({ ...options, measureMs });
    for (const fault of measurement.faults) faults.add(fault);
    const value = measurement.figures[key] ?? Number.NaN;
    if (value < least * (1 - GAIN)) steadyCount = 0;
    else steadyCount += 1;
    if (value < least) least = value;
  }
  return [...faults];
}
