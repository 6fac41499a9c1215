import { ReplayConflict } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import {
  chosenTopics,
  DEFAULT_LIVE_CHOICE,
  livePublishers,
  liveRequest,
  prefixError,
  renamedTopic,
} from './live-choice.ts';

const RECORDED = ['/ada/touch', '/ada/motion', '/lab/angle'];

describe('how a recording is played into live topics', () => {
  it('plays all topics but those that are left out', () => {
    expect(chosenTopics(DEFAULT_LIVE_CHOICE, RECORDED)).toEqual(RECORDED);
    const choice = { ...DEFAULT_LIVE_CHOICE, excluded: '/lab/**, /*/motion' };
    expect(chosenTopics(choice, RECORDED)).toEqual(['/ada/touch']);
  });

  it('plays chosen topics and those that match a pattern', () => {
    const choice = { ...DEFAULT_LIVE_CHOICE, by: 'topics', topics: ['/lab/angle'] } as const;
    expect(chosenTopics(choice, RECORDED)).toEqual(['/lab/angle']);
    expect(chosenTopics({ ...choice, patterns: '/ada/t*' }, RECORDED)).toEqual([
      '/ada/touch',
      '/lab/angle',
    ]);
    expect(liveRequest({ ...choice, patterns: '/ada/t*' }, 'r', AT_START).topics).toEqual([
      '/lab/angle',
      '/ada/t*',
    ]);
  });

  it('renames by the longest prefix; rows without a prefix rename nothing', () => {
    const renames = [
      { from: '', to: '/nowhere' },
      { from: '/ada', to: '/ben' },
      { from: '/ada/t', to: '/t' },
    ];
    expect(RECORDED.map((topic) => renamedTopic(topic, renames))).toEqual([
      '/touch',
      '/ben/motion',
      '/lab/angle',
    ]);
    const request = liveRequest({ ...DEFAULT_LIVE_CHOICE, renames }, 'r', AT_START);
    expect(request.renames).toEqual([
      { fromPrefix: '/ada', toPrefix: '/ben' },
      { fromPrefix: '/ada/t', toPrefix: '/t' },
    ]);
  });

  it('takes rate and loop over from the page', () => {
    const loop = { fromMs: 100, untilMs: 300 };
    expect(liveRequest(DEFAULT_LIVE_CHOICE, 'r', { rate: 2, loop })).toMatchObject({
      recordingId: 'r',
      rate: 2,
      isPaused: true,
      isLooping: true,
      span: loop,
      conflict: ReplayConflict.REPLAY_CONFLICT_MUTE_LIVE,
      livePrefix: '',
    });
    expect(liveRequest(DEFAULT_LIVE_CHOICE, 'r', AT_START).span).toBeUndefined();
  });

  it('finds the clients that publish the same topics now', () => {
    const rate = (topic: string, publisherId: string) => ({ statistic: { topic, publisherId } });
    const rates = [rate('/a', 'ben'), rate('/b', 'ada'), rate('/c', 'ada'), rate('/d', 'eve')];
    expect(livePublishers(new Set(['/a', '/b', '/c']), rates)).toEqual([
      { clientId: 'ada', topics: ['/b', '/c'] },
      { clientId: 'ben', topics: ['/a'] },
    ]);
  });

  it('says what is wrong with a prefix', () => {
    expect(prefixError('/live')).toBeUndefined();
    expect(prefixError('live')).toMatch(/slash/);
    expect(prefixError('/live/')).toMatch(/end/);
  });
});

const AT_START = { rate: 1, loop: undefined };
