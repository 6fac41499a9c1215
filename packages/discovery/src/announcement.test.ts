import { describe, expect, it } from 'vitest';
import { fromTxt, instanceName, toTxt } from './announcement.ts';
import type { Announcement } from './announcement.ts';

const workshop: Announcement = {
  name: 'Workshop',
  id: 'aaaa',
  version: '0.1.0',
  port: 8080,
  https: true,
  servicesPort: 8102,
  topicDataPort: 8104,
};

describe('what a master says of itself [DI-2]', () => {
  it('is read as it was written', () => {
    expect(fromTxt(toTxt(workshop), 8080)).toEqual(workshop);
    expect(fromTxt(toTxt({ ...workshop, https: false }), 8080)).toMatchObject({ https: false });
  });

  it('fits, however long the name is', () => {
    const txt = toTxt({ ...workshop, name: 'Wörkshöp'.repeat(100) });
    for (const [key, value] of Object.entries(txt)) {
      expect(new TextEncoder().encode(`${key}=${value}`).length).toBeLessThan(256);
      expect(key.length).toBeLessThanOrEqual(9);
    }
  });

  it('is nothing when it is of something else', () => {
    for (const txt of [undefined, {}, { id: '' }, { id: 3 }, { name: 'printer' }]) {
      expect(fromTxt(txt, 8080)).toBeUndefined();
    }
    expect(fromTxt(toTxt(workshop), 0)).toBeUndefined();
  });

  it('does no harm when it is meant to', () => {
    const evil = { id: 'x', name: '\u001b[31mred\n', services: '99999', topicdata: 'abc' };
    expect(fromTxt(evil, 1234)).toMatchObject({
      name: '[31mred',
      servicesPort: 1234,
      topicDataPort: 1234,
    });
  });
});

describe('the name of the instance [DI-3]', () => {
  it('is that of the master, and has a number when it is not the first', () => {
    expect(instanceName('Workshop', 1)).toBe('Workshop');
    expect(instanceName('Workshop', 2)).toBe('Workshop (2)');
    expect(instanceName('node-1.lab', 1)).toBe('node-1-lab');
  });

  it('has at most 63 bytes', () => {
    const name = instanceName('ü'.repeat(100), 12);
    expect(new TextEncoder().encode(name).length).toBeLessThanOrEqual(63);
    expect(name.endsWith('ü (12)')).toBe(true);
  });
});
