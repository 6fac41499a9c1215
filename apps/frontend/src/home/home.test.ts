import { describe, expect, it } from 'vitest';
import { homeSentence } from './home-sentence.ts';
import { problemParts } from './problem-parts.ts';

describe('homeSentence', () => {
  const calm = {
    active: 5,
    silent: 0,
    errors: 0,
    warnings: 0,
    running: 0,
    troubled: 0,
    recordsPerSecond: 1842,
  };

  it.each([
    [calm, 'Five clients are connected and data is flowing.'],
    [{ ...calm, recordsPerSecond: 0 }, 'Five clients are connected, and none publishes data.'],
    [{ ...calm, recordsPerSecond: undefined }, 'Five clients are connected.'],
    [{ ...calm, active: 1 }, 'Only this browser is connected.'],
    [
      { ...calm, running: 3, troubled: 1, warnings: 2 },
      'Three sessions run for five clients. One needs attention.',
    ],
    [
      { ...calm, running: 1, troubled: 1 },
      'One session runs for five clients. It needs attention.',
    ],
    [
      { ...calm, running: 2, troubled: 1, errors: 1 },
      'Two sessions run for five clients. One problem needs attention.',
    ],
    [{ ...calm, active: 1, running: 1 }, 'One session runs for this browser only.'],
    [{ ...calm, active: 13 }, '13 clients are connected and data is flowing.'],
    [
      { ...calm, errors: 1 },
      'Five clients are connected and data is flowing. One problem needs attention.',
    ],
    [
      { ...calm, errors: 2 },
      'Five clients are connected and data is flowing. Two problems need attention.',
    ],
    [
      { ...calm, silent: 1 },
      'Five clients are connected and data is flowing. One client lost its connection.',
    ],
    [
      { ...calm, warnings: 3 },
      'Five clients are connected and data is flowing. Three warnings need attention.',
    ],
  ])('%o', (facts, expected) => {
    const { is, asks } = homeSentence(facts);
    expect([is, asks].filter(Boolean).join(' ')).toBe(expected);
  });
});

it('a problem’s sentence is set with the name apart', () => {
  expect(problemParts('Mara went silent.', 'Mara')).toEqual({
    subject: 'Mara',
    text: 'went silent.',
  });
  expect(problemParts('Too many topics.', undefined)).toEqual({
    subject: undefined,
    text: 'Too many topics.',
  });
});
