import { describe, expect, it } from 'vitest';
import { TouchEventType } from '@ubii/proto';
import { Gathering } from './gathering.ts';

const phone = (id: string, deviceName = 'web-interface-smart-device') => ({
  id,
  name: id,
  active: true,
  deviceNames: [deviceName],
});
const touch = (id: string, x: number, y: number, type: TouchEventType = 0) => ({
  elements: [{ type, id, position: { x, y }, force: 0 }],
});

describe('the gathering client', () => {
  it('has every finger of every phone, until it is lifted', () => {
    const gathering = new Gathering();
    gathering.setClients([phone('b'), phone('a'), phone('desk', 'mouse')]);
    expect(gathering.phones().map(({ id }) => id)).toEqual(['a', 'b']);
    gathering.touch('a', touch('1', 0.2, 0.3));
    gathering.touch('a', touch('2', 4, -1));
    gathering.touch('b', touch('1', 0.5, 0.5));
    gathering.touch('desk', touch('1', 0.5, 0.5));
    expect(gathering.touches()).toMatchObject([
      { clientId: 'b', isFirst: true },
      { key: 'a 1', x: 0.2, y: 0.3, isFirst: true },
      { key: 'a 2', x: 1, y: 0, isFirst: false },
    ]);
    gathering.touch('a', touch('1', 0.2, 0.3, TouchEventType.TOUCH_END));
    expect(gathering.touches().map(({ key, isFirst }) => `${key} ${isFirst}`)).toEqual([
      'b 1 true',
      'a 2 true',
    ]);
  });

  it('a phone that leaves takes everything with it', () => {
    const gathering = new Gathering();
    gathering.setClients([phone('a'), phone('b')]);
    gathering.touch('a', touch('1', 0.2, 0.3));
    gathering.move('a', { x: 3, y: 4, z: 0 });
    gathering.setNear('a', true);
    expect(gathering.motionOf('a')).toBe(5);
    gathering.setClients([phone('b')]);
    gathering.setClients([phone('a'), phone('b')]);
    expect(gathering.touches()).toEqual([]);
    expect(gathering.motionOf('a')).toBeUndefined();
    expect(gathering.isNear('a')).toBe(false);
  });

  it('links those the session calls near, by the distance', () => {
    const gathering = new Gathering();
    gathering.setClients([phone('a'), phone('b'), phone('c'), phone('d')]);
    gathering.touch('a', touch('1', 0.1, 0.1));
    gathering.touch('b', touch('1', 0.15, 0.1));
    gathering.touch('c', touch('1', 0.9, 0.9));
    gathering.touch('d', touch('1', 0.12, 0.1));
    expect(gathering.pairs(0.1)).toEqual([]);
    for (const id of ['a', 'b', 'c']) gathering.setNear(id, true);
    expect(gathering.pairs(0.1).map(({ key }) => key)).toEqual(['a b']);
    gathering.setNear('b', false);
    expect(gathering.pairs(0.1)).toEqual([]);
    gathering.forgetNear();
    expect(gathering.isNear('a')).toBe(false);
  });
});
