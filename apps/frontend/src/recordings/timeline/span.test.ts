import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { clampSpan, lengthOf, panSpan, spanShowing, timeAt, xOf, zoomSpan } from './span.ts';

const HOUR = 3_600_000;
const aSpan = fc
  .tuple(
    fc.double({ min: 0, max: HOUR, noNaN: true }),
    fc.double({ min: 1, max: HOUR, noNaN: true }),
  )
  .map(([fromMs, length]) => clampSpan({ fromMs, untilMs: fromMs + length }, HOUR));

describe('the span of a timeline', () => {
  it('stays inside the recording however it is moved and zoomed', () => {
    fc.assert(
      fc.property(
        aSpan,
        fc.double({ min: 0.01, max: 100, noNaN: true }),
        fc.double({ min: -HOUR, max: HOUR, noNaN: true }),
        (span, factor, byMs) => {
          const next = panSpan(zoomSpan(span, factor, span.fromMs + 5, HOUR), byMs, HOUR);
          expect(next.fromMs).toBeGreaterThanOrEqual(0);
          expect(next.untilMs).toBeLessThanOrEqual(HOUR + 1e-6);
          expect(lengthOf(next)).toBeGreaterThanOrEqual(1 - 1e-6);
        },
      ),
    );
  });

  it('zooms around the pointer', () => {
    const span = { fromMs: 1000, untilMs: 3000 };
    const next = zoomSpan(span, 0.5, 1500, HOUR);
    expect(lengthOf(next)).toBe(1000);
    expect(xOf(1500, next, 800)).toBeCloseTo(xOf(1500, span, 800));
  });

  it('maps places to moments and back', () => {
    const span = { fromMs: 250, untilMs: 1250 };
    expect(timeAt(xOf(700, span, 640), span, 640)).toBeCloseTo(700);
  });

  it('follows a playhead by pages', () => {
    const span = { fromMs: 0, untilMs: 1000 };
    expect(spanShowing(span, 900, HOUR)).toBe(span);
    expect(spanShowing(span, 1001, HOUR)).toEqual({ fromMs: 901, untilMs: 1901 });
    expect(spanShowing({ fromMs: 5000, untilMs: 6000 }, 4999, HOUR).fromMs).toBeCloseTo(4099);
  });
});
