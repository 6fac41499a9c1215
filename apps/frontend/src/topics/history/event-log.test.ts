import { ButtonEventType, TouchEventType, type DataFormat, type TopicRecord } from '@ubii/proto';
import { expect, it } from 'vitest';
import { EventLog, MAX_ENTRIES } from './event-log.ts';

const record = (format: DataFormat, value: unknown): TopicRecord =>
  ({ topic: '/a', clientId: '', timestampMs: 0, format, value }) as TopicRecord;
const key = (name: string, type: number) => record('keyEvent', { key: name, type });
const touch = (id: string, type: number, x = 0.5) =>
  record('touchEvent', { id, type, position: { x, y: 0.25 }, force: 0 });

it('counts presses, and knows how long each was', () => {
  const log = new EventLog();
  log.add(key('a', ButtonEventType.DOWN), 100);
  log.add(key('a', ButtonEventType.DOWN), 150); // held, it repeats
  log.add(key('b', ButtonEventType.DOWN), 200);
  log.add(key('a', ButtonEventType.UP), 300);
  const [a, b] = log.tallies;
  expect(a).toMatchObject({ name: 'a', isDown: false, downs: 2, ups: 1 });
  expect(a?.spans).toEqual([{ fromMs: 100, toMs: 300 }]);
  expect(b).toMatchObject({ name: 'b', isDown: true, spans: [{ fromMs: 200, toMs: undefined }] });
  expect(log.entries.map(({ name, action }) => `${name} ${action}`)).toEqual([
    'a up',
    'b down',
    'a down',
    'a down',
  ]);
});

it('follows fingers, and lists moves of one as one', () => {
  const log = new EventLog();
  log.add(touch('1', TouchEventType.TOUCH_START, 0.1), 1);
  for (let x = 2; x < 9; x++) log.add(touch('1', TouchEventType.TOUCH_MOVE, x / 10), x);
  expect(log.entries[0]).toMatchObject({ action: 'move', times: 7 });
  expect(log.entries).toHaveLength(2);
  expect(log.fingers).toMatchObject([{ id: '1', x: 0.8, y: 0.25, isGone: false }]);
  log.add(touch('1', TouchEventType.TOUCH_END, 0.8), 20);
  expect(log.fingers[0]?.isGone).toBe(true);
  expect(log.count).toBe(9);
});

it('takes every event of a list, changes of a bool, and gestures until the next', () => {
  const list = new EventLog();
  const elements = ['1', '2'].map((id) => touch(id, TouchEventType.TOUCH_START).value);
  list.add(record('touchEventList', { elements }), 1);
  expect(list.tallies.map(({ name }) => name).sort()).toEqual(['finger 1', 'finger 2']);

  const bool = new EventLog();
  for (const [at, value] of [true, true, false, true].entries())
    bool.add(record('bool', value), at);
  expect(bool.tallies[0]).toMatchObject({ downs: 2, ups: 1, isDown: true });

  const myo = new EventLog();
  for (const [at, gesture] of [0, 4, 4, 1].entries()) myo.add(record('myoEvent', { gesture }), at);
  expect(myo.tallies.map(({ name, isDown }) => [name, isDown])).toEqual([
    ['fingers spread', true],
    ['fist', false],
    ['rest', false],
  ]);
});

it('is bounded', () => {
  const log = new EventLog();
  for (let at = 0; at < 3000; at++) log.add(key(`k${at % 500}`, at % 2), at);
  expect(log.count).toBe(3000);
  expect(log.entries.length).toBe(MAX_ENTRIES);
  expect(log.tallies.length).toBeLessThan(100);
});
