import { fromJson, ModuleEventKind, type ModuleEvent } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import {
  eventLook,
  eventPlace,
  filterEvents,
  firstCause,
  groupEvents,
  MAX_EVENTS,
  withEvent,
} from './event-log.ts';
import { sessionTotals } from './session-totals.ts';

const event = (json: object): ModuleEvent => fromJson('ubii.extension.ModuleEvent', json);

describe('events', () => {
  const log = event({ kind: 'LOG', moduleId: 'a', level: 'info', message: 'hello' });
  const error = event({ kind: 'ERROR', moduleId: 'b', phase: 'onProcessing', line: 7, column: 2 });

  it('are shown newest first, all, those that are problems, or what modules write', () => {
    const events = [log, error];
    expect(filterEvents(events, 'all', '')).toEqual([error, log]);
    expect(filterEvents(events, 'problems', '')).toEqual([error]);
    expect(filterEvents(events, 'log', '')).toEqual([log]);
    expect(filterEvents(events, 'all', 'a')).toEqual([log]);
  });

  it('are kept up to a number', () => {
    const many = Array.from({ length: MAX_EVENTS + 5 }, (_, line) => event({ line }));
    expect(withEvent([], many)).toHaveLength(MAX_EVENTS);
    expect(withEvent(many, [log]).at(-1)).toBe(log);
  });

  it('of the same problem are one with their number, also when numbers in it differ', () => {
    const refused = (timeMs: number, message: string, suppressed = 0): ModuleEvent => ({
      ...event({ kind: 'REFUSED', moduleId: 'a', message, suppressed }),
      timeMs,
    });
    const events = [
      refused(1, 'Output "x": 3 is too far'),
      refused(2, 'Output "y": write { double: value }'),
      refused(3, 'Output "x": 4.5 is too far', 28),
    ];
    expect(groupEvents([...events].reverse())).toMatchObject([
      { event: { message: 'Output "x": 4.5 is too far' }, firstMs: 1, count: 30 },
      { event: { message: 'Output "y": write { double: value }' }, count: 1 },
    ]);
    expect(firstCause(events, 'a')).toMatchObject({ firstMs: 1, count: 30 });
    expect(firstCause(events, 'a', 10_002)).toMatchObject({ firstMs: 1 });
    expect(firstCause(events, 'a', 20_000)).toBeUndefined();
    expect(firstCause(events, 'other')).toBeUndefined();
  });

  it('of the log are one only where they follow each other', () => {
    const lines = ['tick', 'tick', 'tock', 'tick'].map((message) =>
      event({ kind: 'LOG', message }),
    );
    expect(groupEvents(lines).map(({ count, event: { message } }) => [message, count])).toEqual([
      ['tick', 2],
      ['tock', 1],
      ['tick', 1],
    ]);
  });

  it('say where in the code they happened [PM-13]', () => {
    expect(eventPlace(error)).toBe('onProcessing:7:2');
    expect(eventPlace(event({ phase: 'onCreated' }))).toBe('onCreated');
    expect(eventPlace(log)).toBe('');
  });

  it('have a word, never a colour alone', () => {
    expect(eventLook({ kind: ModuleEventKind.KILLED, level: '' })).toEqual({
      word: 'killed',
      tone: 'err',
    });
    expect(eventLook({ kind: ModuleEventKind.LOG, level: 'warn' }).tone).toBe('warn');
    expect(eventLook({ kind: ModuleEventKind.LOG, level: '' }).word).toBe('log');
  });
});

describe('sessionTotals', () => {
  it('sums counters; of run times the slowest module counts [SE-50]', () => {
    const { modules } = fromJson('ubii.extension.SessionStatistics', {
      modules: [
        {
          runsPerSecond: 60,
          runP50Ms: 0.2,
          runP95Ms: 0.5,
          errors: 1,
          overruns: 2,
          memoryBytes: 3e6,
        },
        { runsPerSecond: 30, runP50Ms: 3, runP95Ms: 0.4, errors: 2, memoryBytes: 4e6 },
        { runsPerSecond: 0, runP50Ms: 99, runP95Ms: 99 },
      ],
    });
    expect(sessionTotals({ modules })).toMatchObject({
      runsPerSecond: 90,
      p50Ms: 3,
      p95Ms: 0.5,
      errors: 3,
      overruns: 2,
      memoryBytes: 7e6,
    });
    expect(sessionTotals({ modules: [] }).p50Ms).toBeUndefined();
  });
});
