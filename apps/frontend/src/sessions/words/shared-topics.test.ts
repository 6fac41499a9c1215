import { SessionState } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { sessionRow, filterRows } from '../list/session-rows.ts';
import { aSession } from '../testing/a-session.ts';
import {
  mappedTopics,
  runningWriters,
  sharedTopics,
  sharedWords,
  writtenTopics,
} from './shared-topics.ts';

const { SESSION_RUNNING, SESSION_STOPPED } = SessionState;
const one = aSession({ id: '1', name: 'One', state: SESSION_RUNNING });
const two = aSession({ id: '2', name: 'Two', state: SESSION_RUNNING });
const rests = aSession({ id: '3', name: 'Rests', state: SESSION_STOPPED });
const [topic = ''] = writtenTopics(one);

it('topics of a session are those it reads and those it writes, each once', () => {
  const topics = mappedTopics(one);
  expect(topics).toContain(topic);
  expect(topics).toEqual([...new Set(topics)]);
  expect(topics.length).toBeGreaterThan(writtenTopics(one).size);
});

describe('topics that several sessions write', () => {
  it('are those of sessions that run', () => {
    expect(topic).not.toBe('');
    expect(sharedTopics(one, [one, two, rests])).toEqual([
      { topic, others: [{ id: '2', name: 'Two' }] },
    ]);
    expect(sharedTopics(rests, [one, two, rests])).toEqual([]);
    expect(sharedTopics(one, [one, rests])).toEqual([]);
    expect([...runningWriters([one, two, rests], '3').get(topic)!].map(({ id }) => id)).toEqual([
      '1',
      '2',
    ]);
  });

  it('are told with the names of the others, and found among the problems', () => {
    const [shared] = sharedTopics(one, [one, two]);
    expect(sharedWords(shared!)).toBe(
      `The session "Two" runs and writes ${topic}, too; the last record wins.`,
    );
    const row = sessionRow(one, undefined, {
      shared: [shared!],
      hasDraft: false,
      master: undefined,
    });
    expect(filterRows([row], '', 'problems')).toHaveLength(1);
  });
});
