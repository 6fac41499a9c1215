import type { JsonValue } from '@ubii/proto';
import { expect, it } from 'vitest';
import { aSeries, readPlotSettings, withSeries, writePlotSettings } from './plot-settings.ts';
import { looksOf, seriesNames } from './series-look.ts';

it('settings come back as they were', () => {
  const settings = {
    series: [
      aSeries('/a', ''),
      { ...aSeries('/b', 'position.x'), isDerivative: true, isHidden: true, axis: 3 },
    ],
    spanMs: 60_000,
    hasNumbers: true,
  };
  expect(readPlotSettings(writePlotSettings(settings))).toEqual(settings);
  expect(readPlotSettings({})).toEqual({
    series: undefined,
    spanMs: undefined,
    hasNumbers: false,
  });
});

it('settings of a stranger are bounded', () => {
  const many = Array.from({ length: 99 }, (_, i) => ({ topic: `/t${i}` }));
  expect(readPlotSettings({ series: many }).series).toHaveLength(20);
  const odd: JsonValue[] = [
    1,
    null,
    {},
    { topic: 7 },
    { topic: '/a', axis: 99 },
    { topic: '/b', path: 5 },
  ];
  expect(readPlotSettings({ series: odd, span: 1e12 })).toMatchObject({
    series: [{ topic: '/a', axis: 4 }],
    spanMs: undefined,
  });
});

it('no line is added twice', () => {
  const one = aSeries('/a', 'x');
  expect(withSeries([one], [one, aSeries('/a', 'y')])).toHaveLength(2);
});

it('names are as short as they can be', () => {
  expect(seriesNames([aSeries('/a', ''), { ...aSeries('/a', 'x'), isDerivative: true }])).toEqual([
    'value',
    'x′',
  ]);
  expect(
    seriesNames([
      aSeries('/arm/left', 'position.x'),
      aSeries('/arm/left', 'velocity.x'),
      aSeries('/arm/right', 'position.x'),
      aSeries('/arm/right', 'position.y'),
    ]),
  ).toEqual(['left position.x', 'left velocity.x', 'right x', 'right y']);
  expect(seriesNames([aSeries('/l/angle', ''), aSeries('/r/angle', '')])).toEqual([
    'l/angle',
    'r/angle',
  ]);
});

it('no two lines of a family look the same', () => {
  const looks = looksOf(Array.from({ length: 12 }, () => 'vector' as const));
  expect(new Set(looks.map(({ tone, dash }) => `${tone} ${dash.join()}`)).size).toBe(12);
});
