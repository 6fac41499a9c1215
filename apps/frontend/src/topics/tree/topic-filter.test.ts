import { describe, expect, it } from 'vitest';
import { parseTopicFilter } from './topic-filter.ts';

const TOPIC = '/3f2b/smart-device/linear_acceleration';
const NAMES = ['Mara · Pixel 9'];
const accepts = (search: string) => parseTopicFilter(search).accepts(TOPIC, NAMES);

describe('parseTopicFilter', () => {
  it('lets everything pass when nothing is searched for', () => {
    expect(parseTopicFilter('  ').isEmpty).toBe(true);
    expect(parseTopicFilter('client:').isEmpty).toBe(true);
    expect(accepts('')).toBe(true);
  });

  it.each([
    ['ACCEL', true],
    ['device/linear', true],
    ['compass', false],
    ['mara', true], // the client's name
    ['accel mara', true],
    ['accel theo', false],
    ['"Pixel 9"', true],
    ['"pixel 8"', false],
    ['client:pixel', true],
    ['client:"mara · pixel"', true],
    ['client:accel', false], // names only
    ['CLIENT:Mara accel', true],
    ['linear_*', true],
    ['*accel*', true],
    ['/3f2b/**', true],
    ['accel*', false],
    ['Linear_*', true],
  ])('%s: %s', (search, accepted) => {
    expect(accepts(search)).toBe(accepted);
  });

  it('takes an open quote while it is being typed', () => {
    expect(accepts('"Pixel')).toBe(true);
  });
});
