import { describe, expect, it } from 'vitest';
import { durationFigure } from '../measure/duration-figures.ts';
import { figureReadout, NO_FINDINGS, type Figure } from '../measure/findings.ts';
import { figureMeaning } from './figure-words.ts';
import { verdictOf } from './verdict.ts';

const p95 = (value: number, way = 'immediate'): Figure =>
  durationFigure(`${way}.p95`, '95 of 100', value);
const said = (...figures: readonly Figure[]) =>
  verdictOf('round-trip', { ...NO_FINDINGS, figures });

describe('the verdict on a round trip', () => {
  it('has the number of the table, with one decimal', () => {
    for (const value of [1, 3.14, 47.46, 230.2]) {
      const { digits, unit } = figureReadout(p95(value));
      expect(digits).toMatch(/^\d+\.\d$/);
      expect(said(p95(value))?.text).toContain(`within ${digits} ${unit}`);
    }
  });

  it('needs no fractions of a millisecond', () => {
    expect(figureReadout(p95(0.432)).digits).toBe('0.43');
    expect(said(p95(0.432))?.text).toContain('within 1 ms: not noticeable');
  });

  it('names both ways, and is that of the slower one', () => {
    expect(said(p95(3.14), p95(31.2, 'aggregated'))).toEqual({
      tone: 'fair',
      text: 'Immediate: 95 of 100 values arrive back within 3.1 ms: not noticeable. Aggregated: 95 of 100 values arrive back within 31.2 ms: buttons feel direct, and what follows a hand trails behind it.',
    });
    expect(said(p95(131), p95(12, 'aggregated'))?.tone).toBe('poor');
  });

  it('says of a latency what its explanation says', () => {
    const meaning = figureMeaning(p95(0));
    expect(said(p95(19))?.text).toContain('not noticeable');
    expect(meaning).toContain('Up to 20 ms is not noticeable');
    const fair = 'buttons feel direct, and what follows a hand trails behind it';
    expect(said(p95(47))?.text).toContain(fair);
    expect(meaning).toContain(`Up to 100 ms ${fair}`);
    expect(said(p95(101))?.tone).toBe('poor');
  });
});
