import { describe, expect, it } from 'vitest';
import { rootLabel, topicLevels } from './topic-path.ts';

const keys = (topic: string) => topicLevels(topic).map(({ key }) => key);
const labels = (topic: string) => topicLevels(topic).map(({ label }) => label);

describe('topicLevels', () => {
  it('splits by slash, outermost first', () => {
    expect(keys('/mara/smart-device/acceleration')).toEqual([
      '/mara',
      '/mara/smart-device',
      '/mara/smart-device/acceleration',
    ]);
    expect(labels('/mara/smart-device/acceleration')).toEqual([
      'mara',
      'smart-device',
      'acceleration',
    ]);
  });

  it('keeps a topic without leading slash apart', () => {
    expect(keys('mara/x')).toEqual(['mara', 'mara/x']);
    expect(labels('mara/x')).toEqual(['mara', 'x']);
  });

  it('keeps empty levels, so that every topic has a place of its own', () => {
    expect(labels('/')).toEqual(['']);
    expect(labels('//a/')).toEqual(['', 'a', '']);
    expect(keys('//a/')).toEqual(['/', '//a', '//a/']);
  });

  it('ends with the topic itself', () => {
    for (const topic of ['/', '/a', 'a', '/a/b', '//', '/a//b/', 'ä/ö']) {
      expect(keys(topic).at(-1)).toBe(topic);
    }
  });
});

describe('rootLabel', () => {
  it('is the first level', () => {
    expect(rootLabel('/mara/x')).toBe('mara');
    expect(rootLabel('mara/x')).toBe('mara');
    expect(rootLabel('/mara')).toBe('mara');
    expect(rootLabel('//x')).toBe('');
  });
});
