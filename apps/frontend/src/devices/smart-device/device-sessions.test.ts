import type { Session } from '@ubii/proto';
import { expect, it } from 'vitest';
import { sessionsReading } from './device-sessions.ts';

const session = (name: string, topic: string): Session =>
  ({ id: name, name, ioMappings: [{ inputMappings: [{ topic }] }] }) as unknown as Session;

it('finds the sessions that read what a phone sends', () => {
  const sessions = [
    session('mine', '/phone/smart device/touch_position'),
    session('turned', 'phone/orientation'),
    session('of another', '/phone2/smart device/touch_position'),
    session('of nobody', '/lab/light'),
  ];
  expect(sessionsReading(sessions, 'phone').map(({ name }) => name)).toEqual(['mine', 'turned']);
  expect(sessionsReading(sessions, '')).toEqual([]);
});
