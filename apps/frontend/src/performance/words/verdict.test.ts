import { describe, expect, it } from 'vitest';
import { figureReadout, NO_FINDINGS, type Figure } from '../measure/findings.ts';
import { figureMeaning } from './figure-words.ts';
import { verdictOf } from './verdict.ts';

const p95 = (value: number): Figure => ({
  key: 'immediate.p95',
  label: '95 of 100',
  value,
  unit: 'ms',
  decimals: 1,
});
const said = (figure: Figure) => verdictOf('round-trip', { ...NO_FINDINGS, figures: [figure] });

describe('the verdict on a round trip', () => {
  it('has the number of the table', () => {
    for (const value of [3.14, 47.46, 230.2]) {
      const { digits, unit } = figureReadout(p95(value));
      expect(said(p95(value))?.text).toContain(`within ${digits} ${unit}`);
    }
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
