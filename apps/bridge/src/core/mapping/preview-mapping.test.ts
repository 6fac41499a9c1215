import { expect, it } from 'vitest';
import { mappingOf } from '../../testing/mapping-of.ts';
import { previewMapping } from './preview-mapping.ts';

const present = { topics: ['/lamps/hall', '/info/x', '/other'], addresses: ['sensors/one/temp'] };

it('lists what a mapping selects, in each of its directions [BR-81]', () => {
  const both = mappingOf('both', 'sensors/+/temp', '/sensors/{1}/temp');
  expect(previewMapping(both, { ...present, topics: ['/sensors/two/temp'] })).toEqual({
    more: 0,
    matches: [
      {
        inward: true,
        isExample: false,
        source: 'sensors/one/temp',
        target: '/sensors/one/temp',
      },
      {
        inward: false,
        isExample: false,
        source: '/sensors/two/temp',
        target: 'sensors/two/temp',
      },
    ],
  });
});

it.each([
  ['in', 'sensors/+/light', '/light/{1}', 'sensors/a/light', '/light/a'],
  ['in', 'home/#', '/home/{1}', 'home/a/a', '/home/a/a'],
  ['in', 'a/+/+', '/{2}/{1}', 'a/a/b', '/b/a'],
  ['in', 'status', '/status', 'status', '/status'],
  ['out', 'lamps/{1}', '/lights/*', '/lights/a', 'lamps/a'],
] as const)(
  'has one example where nothing matches: %s %s %s [BR-81]',
  (direction, foreign, topic, source, target) => {
    expect(previewMapping(mappingOf(direction, foreign, topic), present)).toEqual({
      more: 0,
      matches: [{ inward: direction === 'in', source, target, isExample: true }],
    });
  },
);
