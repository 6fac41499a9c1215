import type { Replay } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import type { ComparedTopic } from './compare-messages.ts';
import {
  differenceWord,
  progressSentence,
  recordedCodeSentence,
  resultSentence,
} from './compare-words.ts';

const result = (counts: Partial<ComparedTopic>) => ({
  topics: [{ topic: '/a', same: 0, different: 0, missing: 0, additional: 0, ...counts }],
  differences: [],
});

describe('words of a comparison', () => {
  it('say how many outputs differ', () => {
    expect(resultSentence(result({ same: 38, different: 2, missing: 1 }))).toBe(
      '3 of 41 outputs differ from the recording: 2 in value, 1 missing.',
    );
    expect(resultSentence(result({ same: 1, additional: 1 }))).toBe(
      '1 of 2 outputs differs from the recording: 1 additional.',
    );
    expect(resultSentence(result({ same: 1, different: 1 }))).toBe(
      '1 of 2 outputs differs from the recording.',
    );
    expect(resultSentence(result({ same: 5 }))).toBe('All 5 outputs are the same as recorded.');
    expect(resultSentence(result({}))).toMatch(/no outputs/);
  });

  it('name what differs, and modules without code of today', () => {
    const difference = { topic: '/a', timeMs: 0, recorded: '1', today: '2' };
    expect(differenceWord({ ...difference, kind: 'different', path: '' })).toBe('Differs');
    expect(differenceWord({ ...difference, kind: 'different', path: 'position.x' })).toBe(
      'position.x differs',
    );
    expect(recordedCodeSentence(['A', 'B'])).toMatch(/^“A”, “B” are not in the library/);
    expect(recordedCodeSentence([])).toBe('');
  });

  it('say how far a run is', () => {
    const replay = {
      session: { name: 'Gestures' },
      positionMs: 12_000,
      rate: 2,
      span: { fromMs: 2000, untilMs: 62_000 },
    } as Replay;
    expect(progressSentence(replay)).toBe(
      "Session “Gestures” runs with today's modules: 0:10 of 1:00 at 2.00×.",
    );
  });
});
