import { describe, expect, it } from 'vitest';
import { RecordingError } from './recording-error.ts';
import type { EventKind } from './recording-event.ts';
import { parseEvent } from './parse-event.ts';

const TIME_NS = 1_750_000_000_000_000_000n;
const MARKER = { id: 'a', timeMs: 1, text: 'Go', author: 'Ada', authorId: 'ada', kind: 'key' };
const DEVICE = {
  id: 'd',
  clientId: 'c',
  name: 'Robot',
  tags: ['arm'],
  state: 'registered',
  components: [
    { id: 'x', name: 'joint', topic: '/x', format: 'double', direction: 'publisher', tags: [] },
  ],
};
const GAP = { fromMs: 1, untilMs: 2, records: 3, reason: 'The disk was slow.' };

const parse = (kind: EventKind, value: unknown) =>
  parseEvent(kind, TIME_NS, new TextEncoder().encode(JSON.stringify(value)));

describe('parseEvent', () => {
  it('returns events as they were written', () => {
    const removed = { ...MARKER, isRemoved: true };
    expect(parse('marker', removed)).toEqual({ kind: 'marker', timeNs: TIME_NS, value: removed });
    expect(parse('device', DEVICE).value).toEqual(DEVICE);
    expect(parse('gap', GAP).value).toEqual(GAP);
  });

  it('leaves out members that it does not know', () => {
    const more = { ...MARKER, secret: 'Ada', ['__proto__']: 1 };
    expect(parse('marker', more).value).toEqual(MARKER);
  });

  it.each<[string, EventKind, unknown, string]>([
    ['null', 'marker', null, 'it is null, and not an object'],
    ['a list', 'client', [], 'it is a list, and not an object'],
    ['a text that is an object', 'marker', { ...MARKER, text: {} }, 'text is an object'],
    ['a time that is a text', 'marker', { ...MARKER, timeMs: '1' }, 'timeMs is a text'],
    ['a time that no file can have', 'marker', { ...MARKER, timeMs: 1e300 }, 'out of range'],
    ['an id that is too long', 'marker', { ...MARKER, id: 'x'.repeat(257) }, '256 characters'],
    ['a missing member', 'marker', { id: 'a' }, 'timeMs is missing'],
    ['tags that are no list', 'client', { id: 'c', name: 'C', tags: 'x', state: '' }, 'not a list'],
    [
      'a component without topic',
      'device',
      { ...DEVICE, components: [{ ...DEVICE.components[0], topic: null }] },
      'components[0].topic is null, and not a text',
    ],
    ['a negative count', 'gap', { ...GAP, records: -1 }, 'records is -1, which is out of range'],
  ])('[RC-55] refuses %s', (_, kind, value, problem) => {
    expect(() => parse(kind, value)).toThrow(RecordingError);
    expect(() => parse(kind, value)).toThrow(problem);
    expect(() => parse(kind, value)).toThrow(`The ${kind} event of 2025-06-15T15:06:40.000Z`);
  });

  it('[RC-55] refuses what cannot be parsed', () => {
    expect(() => parseEvent('marker', TIME_NS, Uint8Array.of(123))).toThrow(
      'it cannot be parsed as JSON',
    );
  });
});
