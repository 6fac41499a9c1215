import { describe, expect, it } from 'vitest';
import { topicLabel, topicLabels } from './topic-label.ts';

const ID = '729eaeb0-49d7-451a-8ad1-e61fb4e201c2';
const RUN = '/replays/0c8a6c1e-6c1f-4d0c-9c0e-4b8a51d5b7a1';
const nameOf = (id: string): string | undefined => (id === ID ? 'Mara' : undefined);

describe('the label of a recorded topic', () => {
  it('is its last level with the client, and has the levels between where those are the same', () => {
    const [left, right, other] = [`/${ID}/left/stick`, `/${ID}/right/stick`, `/${ID}/pad/level`];
    expect([...topicLabels([left, right, other, '/lab/x'], nameOf)]).toEqual([
      [left, 'left/stick · Mara'],
      [right, 'right/stick · Mara'],
      [other, 'level · Mara'],
      ['/lab/x', '/lab/x'],
    ]);
  });

  it('[RP-40] of a session that ran again tells the recorded topic, and whether it is an input', () => {
    expect(topicLabel(`${RUN}/in/${ID}/pad/level`, nameOf).short).toBe('level · Mara, input');
    expect(topicLabel(`${RUN}/out/lab/x`, nameOf)).toEqual({
      short: '/lab/x · output',
      long: '/lab/x · output',
      owner: 'output',
      isOfRun: true,
    });
    expect(topicLabel(`${RUN}/in${ID}/level`, nameOf).short).toBe('level · Mara, input');
  });
});
