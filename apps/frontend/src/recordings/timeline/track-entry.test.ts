import { ButtonEventType, type TopicRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { entryOf, trackKind } from './track-entry.ts';

const aRecord = (format: string, value: unknown): TopicRecord =>
  ({ topic: '/a', format, value }) as unknown as TopicRecord;

describe('trackKind()', () => {
  it.each([
    ['vector3', 'lines'],
    ['double', 'lines'],
    ['floatList', 'lines'],
    ['quaternion', 'lines'],
    ['pose3D', 'lines'],
    ['touchEvent', 'ticks'],
    ['bool', 'ticks'],
    ['string', 'text'],
    ['image2D', 'frames'],
    ['object2DList', 'bars'],
    ['session', 'bytes'],
    [undefined, 'bytes'],
  ] as const)('draws %s as %s', (format, kind) => {
    expect(trackKind(format)).toBe(kind);
  });
});

describe('entryOf()', () => {
  it('reads the numbers of a vector', () => {
    expect(entryOf(aRecord('vector2', { x: 1, y: 2 })).numbers).toEqual([1, 2]);
  });

  it('says what is held, seen and written', () => {
    const key = { key: 'a', type: ButtonEventType.DOWN };
    expect(entryOf(aRecord('keyEvent', key)).states).toEqual(['a']);
    expect(entryOf(aRecord('bool', false)).states).toEqual([]);
    const elements = [{ id: 'cup' }, { id: 'cup' }, { id: '' }];
    expect(entryOf(aRecord('object2DList', { elements })).states).toEqual(['cup', 'object 3']);
    expect(entryOf(aRecord('string', 'swipe')).states).toEqual(['swipe']);
  });
});
