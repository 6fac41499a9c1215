import { FakeClock } from '@ubii/timing/testing';
import { expect, it } from 'vitest';
import { EventLog } from '../counters/event-log.ts';
import { LimitWatch } from '../counters/limit-watch.ts';
import { DEFAULT_LIMITS } from '../limits/index.ts';
import { RecordingLog } from '../../testing/recording-log.ts';
import { recordedSession } from './recorded-session.ts';

function read(session: string) {
  const [clock, log] = [new FakeClock(), new RecordingLog()];
  const events = new EventLog(clock, log, DEFAULT_LIMITS);
  const watch = new LimitWatch(DEFAULT_LIMITS, clock, log, events);
  return recordedSession({ id: 'a', name: 'A', state: 'running', session }, watch);
}

it('returns the session of a file', () => {
  expect(read('{"name":"Arm"}')).toMatchObject({ name: 'Arm', processingModules: [] });
});

it.each(['', '{', 'null', '[]', '{"ioMappings":{}}'])(
  '[RC-55] refuses %j, which is no session',
  (session) => {
    expect(() => read(session)).toThrow('The recorded session cannot be read.');
  },
);

it('[RC-54] refuses texts that are too long', () => {
  const session = JSON.stringify({ name: 'x'.repeat(257) });
  expect(() => read(session)).toThrow(expect.objectContaining({ code: 'resource_exhausted' }));
});
