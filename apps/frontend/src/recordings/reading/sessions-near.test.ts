import type { RecordingEvent } from '@ubii/recording';
import { describe, expect, it } from 'vitest';
import { TimeBase } from './recording-time-base.ts';
import { sessionsNear } from './sessions-near.ts';

const START_NS = 1_750_000_000_000_000_000n;
const base = new TimeBase(START_NS);
const change = (id: string, state: string, atMs: number): RecordingEvent<'session'> => ({
  kind: 'session',
  timeNs: base.toNs(atMs),
  value: { id, name: id, state, session: `${id} ${state}` },
});
const EVENTS = [
  change('old', 'stopped', 0),
  change('long', 'running', 0),
  change('short', 'running', 1000),
  change('short', 'stopped', 2000),
  change('late', 'running', 3000),
];
const near = (timeMs: number) =>
  sessionsNear(EVENTS, timeMs, base).map(
    ({ id, state, presence, sinceMs }) => `${id} ${state} ${presence} ${sinceMs}`,
  );

describe('the sessions near the playhead', () => {
  it('are those that run, then those that will start', () => {
    expect(near(0)).toEqual([
      'long running present 0',
      'old stopped present 0',
      'short running starts 1000',
      'late running starts 3000',
    ]);
  });

  it('have ended when they ran before', () => {
    expect(near(2500)).toEqual([
      'long running present 0',
      'old stopped present 0',
      'short stopped ended 2000',
      'late running starts 3000',
    ]);
    expect(sessionsNear(EVENTS, 2500, base)[2]!.session).toBe('short stopped');
  });
});
