import { fromJson } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { paletteTopics } from './palette-topics.ts';

const rate = (topic: string, dataFormat = 'double', hz = 5): TopicRate => ({
  statistic: fromJson('ubii.extension.TopicStatistic', { topic, dataFormat }),
  hz,
  bytesPerSecond: 0,
  droppedPerSecond: 0,
  usualHz: hz,
});
const find = (id: string) => (id === 'c1' ? { name: 'Mara', isAway: false } : undefined);

describe('paletteTopics', () => {
  it('groups topics by who publishes them, by name', () => {
    const groups = paletteTopics([rate('/z/b'), rate('/c1/pad/y'), rate('/c1/pad/x')], [], find);
    expect(groups.map(({ name, topics }) => [name, topics.map(({ label }) => label)])).toEqual([
      ['Mara', ['pad/x', 'pad/y']],
      ['z', ['b']],
    ]);
  });

  it('leaves out what the master tells of itself', () => {
    expect(paletteTopics([rate('/info/session/new'), rate('/ubii/client/x')], [], find)).toEqual(
      [],
    );
  });

  it('finds by publisher, topic and format', () => {
    const rates = [rate('/c1/pad', 'vector2'), rate('/z/b')];
    expect(paletteTopics(rates, ['mara', 'vector'], find)).toHaveLength(1);
    expect(paletteTopics(rates, ['nothing'], find)).toEqual([]);
  });
});
