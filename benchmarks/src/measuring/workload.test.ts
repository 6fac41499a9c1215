import { expect, it } from 'vitest';

import { warmed, type Measurement, type MeasureOptions, type Subject } from './workload.ts';

const OPTIONS = { warmUpMs: 10, measureMs: 3_000 };

function measuredAs(values: readonly number[], faults: Record<number, string[]> = {}) {
  const asked: MeasureOptions[] = [];
  const subject: Subject = {
    name: 'subject',
    pids: [1],
    measure: (options): Promise<Measurement> => {
      const count = asked.push(options) - 1;
      const cpuUs = values[Math.min(count, values.length - 1)]!;
      const rest = { deliveries: 1, otherCpuShare: 0, faults: faults[count] ?? [] };
      return Promise.resolve({ figures: { cpuUs }, ...rest });
    },
  };
  return { asked, subject: warmed(subject, 'cpuUs') };
}

it('measures until the figure has not fallen three times, and then once more', async () => {
  const { asked, subject } = measuredAs([100, 60, 58, 50, 49, 52, 48, 47]);
  const { figures } = await subject.measure(OPTIONS);
  expect(figures['cpuUs']).toBe(47);
  expect(asked.map(({ measureMs }) => measureMs)).toEqual([...Array(7).fill(1_000), 3_000]);
});

it('warms up only before the first measurement', async () => {
  const { asked, subject } = measuredAs([100]);
  await subject.measure(OPTIONS);
  const before = asked.length;
  await subject.measure(OPTIONS);
  expect(asked.length - before).toBe(1);
});

it('ends when the figure falls forever, and when there is none', async () => {
  const falling = measuredAs(Array.from({ length: 100 }, (_, index) => 0.9 ** index));
  await falling.subject.measure(OPTIONS);
  expect(falling.asked).toHaveLength(21);
  const none = measuredAs([Number.NaN]);
  await none.subject.measure(OPTIONS);
  expect(none.asked).toHaveLength(4);
});

it('reports what was lost while it warmed up, once', async () => {
  const { subject } = measuredAs([100], { 0: ['1 records lost'], 1: ['1 records lost'] });
  expect((await subject.measure(OPTIONS)).faults).toEqual(['1 records lost']);
  expect((await subject.measure(OPTIONS)).faults).toEqual([]);
});
