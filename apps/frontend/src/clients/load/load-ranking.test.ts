import { describe, expect, it } from 'vitest';
import { aView } from '../testing/a-client.ts';
import { rankLoads } from './load-ranking.ts';

const noisy = aView('Drum', { workShare: 0.7, recordsInPerSecond: 900, bytesInPerSecond: 45_000 });
const slow = aView('Tablet', {
  workShare: 0.2,
  recordsOutPerSecond: 200,
  bytesOutPerSecond: 90_000,
  queuedRecords: 1200,
  queuedBytes: 500_000,
});
const quiet = aView('Lamp', {});
const listener = aView('Log', { workShare: 0.1, recordsOutPerSecond: 9, watchesEverything: true });
const all = [quiet, listener, slow, noisy];
const names = (...args: Parameters<typeof rankLoads>) =>
  rankLoads(...args).map(({ view }) => view.label);

describe('rankLoads', () => {
  it('ranks by work, bandwidth and queue, and leaves out clients without load', () => {
    expect(names(all, 'work', 10)).toEqual(['Drum', 'Tablet', 'Log']);
    expect(names(all, 'bandwidth', 10)).toEqual(['Tablet', 'Drum', 'Log']);
    expect(names(all, 'queue', 10)[0]).toBe('Tablet');
  });

  it('says why, and what to do, in words of its own', () => {
    const [drum, tablet, log] = rankLoads(all, 'work', 80);
    expect(drum).toMatchObject({
      cause: 'Publishes 900 records per second, 45 kB/s.',
      remedy: 'Publish fewer or smaller records, or throttle the client.',
      isTrouble: true,
      isThrottleUseful: true,
    });
    expect(tablet?.cause).toContain('Receives more slowly than data arrives');
    expect(tablet?.isThrottleUseful).toBe(false);
    expect(log).toMatchObject({ remedy: '', isTrouble: false });
    expect(log?.cause).toContain('subscribes to every topic');
  });

  it('is no trouble to take much of a master that has little to do', () => {
    expect(rankLoads([noisy], 'work', 10)[0]).toMatchObject({ isTrouble: false, remedy: '' });
  });

  it('takes the words of the master where it has found a problem', () => {
    const problem = { code: 'client_throttled', text: 'Drum is throttled.', remedy: 'Lift it.' };
    const [load] = rankLoads([aView('Drum', {}, {}, [problem])], 'work', 0);
    expect(load).toMatchObject({ cause: 'Is throttled.', remedy: 'Lift it.', isTrouble: true });
  });
});
