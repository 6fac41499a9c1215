import { describe, expect, it } from 'vitest';
import { PUBLISHED_CONSTANTS } from './testing/published-formats.ts';
import {
  clientTopic,
  componentTopic,
  globToRegExpSource,
  INFO_TOPICS,
  isExtensionTopic,
  isMasterTopic,
  moduleEventTopic,
  RECORDING_STATUS_TOPIC,
  REPLAYS_TOPIC,
  STUDY_STATUS_TOPIC,
  sessionStatisticsTopic,
  UUID_PATTERN,
  isUuid,
} from './topics.ts';

describe('topics', () => {
  it('of the master are those of the published constants, patterns aside', () => {
    const published = Object.values(PUBLISHED_CONSTANTS.DEFAULT_TOPICS.INFO_TOPICS);
    const topics: string[] = Object.values(INFO_TOPICS);
    expect(topics.sort()).toEqual(published.filter((topic) => !topic.includes('*')).sort());
  });

  it.each([
    ['/info/session/start', true],
    ['info/session/start', true],
    ['/ubii/client/x', true],
    ['ubii/client/x', true],
    ['/info', false],
    ['/information/x', false],
    ['//info/x', false],
    ['/client/info/x', false],
    ['', false],
  ])('[TD-16] %j belongs to the master: %j', (topic, expected) => {
    expect(isMasterTopic(topic)).toBe(expected);
  });

  it('[TD-26] below /ubii/ are ours', () => {
    expect(isExtensionTopic(clientTopic('c'))).toBe(true);
    expect(isExtensionTopic('/info/device/new')).toBe(false);
    expect(isExtensionTopic('/services/ubii/topic_statistics')).toBe(false);
  });

  it('of components have three levels by convention', () => {
    expect(componentTopic('c', 'smart-device', 'touch')).toBe('/c/smart-device/touch');
  });

  it('[EX-23] of sessions carry their id, and are ours', () => {
    expect(sessionStatisticsTopic('s')).toBe('/ubii/session/s/statistics');
    expect(moduleEventTopic('s')).toBe('/ubii/session/s/events');
    for (const topic of [sessionStatisticsTopic('s'), moduleEventTopic('s')]) {
      expect(isExtensionTopic(topic)).toBe(true);
      expect(isMasterTopic(topic)).toBe(true);
    }
  });

  it('[RC-8] of the recordings is ours', () => {
    expect(isExtensionTopic(RECORDING_STATUS_TOPIC)).toBe(true);
    expect(isMasterTopic(RECORDING_STATUS_TOPIC)).toBe(true);
  });

  it('[RP-7] of the replays is ours', () => {
    expect(isExtensionTopic(REPLAYS_TOPIC)).toBe(true);
    expect(isMasterTopic(REPLAYS_TOPIC)).toBe(true);
  });

  it('[ST-40] of the studies is ours', () => {
    expect(isExtensionTopic(STUDY_STATUS_TOPIC)).toBe(true);
    expect(isMasterTopic(STUDY_STATUS_TOPIC)).toBe(true);
  });

  it('[CL-31] of clients carry their id', () => {
    expect(clientTopic('c')).toBe('/ubii/client/c');
  });
});

describe('globToRegExpSource', () => {
  it.each([
    ['/a/*/c', '/a/b/c', true],
    ['/a/*/c', '/a/b/b/c', false],
    ['/a/*', '/a/', true],
    ['/a/**', '/a/b/c', true],
    ['/a/**/z', '/a/b/c/z', true],
    ['/a/?', '/a/b', true],
    ['/a/?', '/a//', false],
    ['/a/?', '/a/bc', false],
    ['/a', '/a/b', false],
    ['/a', '/x/a', false],
    ['/a.b', '/axb', false],
    ['/a(b)[c]{d}+$^|\\', '/a(b)[c]{d}+$^|\\', true],
  ])('%j on %j: %j', (glob, topic, expected) => {
    expect(new RegExp(globToRegExpSource(glob)).test(topic)).toBe(expected);
  });
});

describe('isUuid', () => {
  it('is true for a whole UUID only', () => {
    expect(isUuid('0a1b2c3d-0000-5000-8000-0123456789AB')).toBe(true);
    expect(isUuid('../0a1b2c3d-0000-5000-8000-0123456789ab')).toBe(false);
    expect(isUuid('')).toBe(false);
  });
});

describe('UUID_PATTERN', () => {
  it('matches whole ids only when anchored, of either case', () => {
    const pattern = new RegExp(`^${UUID_PATTERN}$`);
    expect(pattern.test('7c1c9e4e-64f1-4a0a-9b5a-3b8a0c1d2e3f')).toBe(true);
    expect(pattern.test('7C1C9E4E-64F1-4A0A-9B5A-3B8A0C1D2E3F')).toBe(true);
    expect(pattern.test('7c1c9e4e-64f1-4a0a-9b5a-3b8a0c1d2e3')).toBe(false);
  });
});
