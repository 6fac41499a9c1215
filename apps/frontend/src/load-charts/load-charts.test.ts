import { describe, expect, it } from 'vitest';
import { chartThatExplains } from './load-charts.ts';

describe('the chart on Home', () => {
  it('is there only for a problem that it explains', () => {
    expect(chartThatExplains([])).toBeUndefined();
    expect(chartThatExplains(['client_throttled', 'limit_reached'])).toBeUndefined();
    expect(chartThatExplains(['publisher_noisy'])).toBe('records');
  });

  it('is one: that of what everybody suffers from', () => {
    expect(chartThatExplains(['publisher_noisy', 'machine_busy'])).toBe('cpu');
    expect(chartThatExplains(['publisher_noisy', 'machine_busy', 'master_busy'])).toBe('busy');
  });
});
