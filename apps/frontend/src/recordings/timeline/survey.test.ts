import type { TopicRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { SurveyBuilder } from './survey.ts';

const aRecord = (format: string, value: unknown): TopicRecord =>
  ({ topic: '/a', format, value }) as unknown as TopicRecord;

describe('the survey of a recording', () => {
  it('has every track over all of the time', () => {
    const builder = new SurveyBuilder(10_000);
    for (let timeMs = 0; timeMs <= 10_000; timeMs += 10)
      builder.add('/a', timeMs, aRecord('double', Math.sin(timeMs / 500)));
    builder.add('/b', 3000, aRecord('string', 'rest'));
    builder.add('/b', 5000, aRecord('string', 'swipe'));
    builder.addFrame('/c', 4000);
    builder.add('/d', 4000, undefined);
    const { tracks, isWhole } = builder.survey(true);
    const [a, b, c, d] = tracks;
    expect(a!.tile.counts.reduce((sum, one) => sum + one, 0)).toBe(1001);
    expect(b!.runs.map(({ label, untilMs }) => [label, untilMs])).toEqual([
      ['rest', 5000],
      ['swipe', 10_000],
    ]);
    expect([...c!.frames]).toEqual([4000]);
    expect(d!.tile.lines).toEqual([]);
    expect(isWhole).toBe(true);
  });

  it('can be shown while it is made', () => {
    const builder = new SurveyBuilder(10_000);
    builder.add('/a', 2000, aRecord('double', 1));
    expect(builder.survey(false)).toMatchObject({ readMs: 2000, isWhole: false });
  });
});
