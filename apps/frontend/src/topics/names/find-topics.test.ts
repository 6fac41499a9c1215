import { expect, it } from 'vitest';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { findTopics } from './find-topics.ts';

it('finds topics by words of their name and format, those of the master last', () => {
  const rates = new Map(
    [
      ['/info/session/new', 'session'],
      ['/z/position', 'vector2'],
      ['/a/position', 'vector3'],
    ].map(([topic, dataFormat]) => [topic!, { statistic: { topic, dataFormat } } as TopicRate]),
  );
  const found = (...words: string[]) => findTopics(rates, words).map(({ topic }) => topic);
  expect(found()).toEqual(['/a/position', '/z/position', '/info/session/new']);
  expect(found('position', 'vector3')).toEqual(['/a/position']);
  expect(found('nothing')).toEqual([]);
});
