import { ClientState } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { aView } from '../testing/a-client.ts';
import {
  filterClients,
  NO_WISHES,
  readWishes,
  sortClients,
  writeWishes,
  type ClientWishes,
} from './client-filter.ts';

const ANDROID = 'Mozilla/5.0 (Linux; Android 16; Pixel 9) Chrome/140 Mobile';

const phone = aView('Pixel', { userAgent: ANDROID, roundTripMs: 20 }, { tags: ['browser'] });
const node = aView('Worker', { roundTripMs: 5 }, { isDedicatedProcessingNode: true });
const away = aView('Robot', {}, { state: ClientState.UNAVAILABLE, description: 'arm' });
const broken = aView('Drum', { recordsInPerSecond: 900 }, {}, [{ code: 'publisher_noisy' }]);
const all = [phone, node, away, broken];

describe('filterClients', () => {
  const names = (wishes: Partial<ClientWishes>) =>
    filterClients(all, { ...NO_WISHES, ...wishes }).map(({ label }) => label);

  it.each([
    [{}, ['Pixel', 'Worker', 'Robot', 'Drum']],
    [{ state: 'lost' }, ['Robot']],
    [{ kind: 'phone' }, ['Pixel']],
    [{ kind: 'node' }, ['Worker']],
    [{ kind: 'program' }, ['Worker', 'Robot', 'Drum']],
    [{ isBroken: true }, ['Drum']],
    [{ text: 'ARM rob' }, ['Robot']],
    [{ text: 'android' }, ['Pixel']],
    [{ text: 'unknown' }, []],
  ] satisfies [Partial<ClientWishes>, string[]][])('%o', (wishes, expected) => {
    expect(names(wishes)).toEqual(expected);
  });

  it('finds clients by their master, among several [CU-70]', () => {
    const atHall = { ...phone, master: 'hall' };
    const atFoyer = { ...node, master: 'foyer' };
    const both = [atHall, atFoyer];
    expect(filterClients(both, { ...NO_WISHES, master: 'hall' })).toEqual([atHall]);
    expect(filterClients(both, { ...NO_WISHES, text: 'foyer' })).toEqual([atFoyer]);
  });

  it('finds a client by what its components are on', () => {
    const components = [{ name: 'stick', topic: '/pad/left' }];
    const devices = [{ name: 'pad', components }] as never;
    const pad = aView('x', {}, { devices });
    expect(filterClients([pad], { ...NO_WISHES, text: '/pad/left' })).toEqual([pad]);
  });
});

describe('sortClients', () => {
  const order = (sort: ClientWishes['sort'], isDescending: boolean) =>
    sortClients(all, { sort, isDescending }).map(({ label }) => label);

  it('by name, and by numbers with what is unknown last, whichever way', () => {
    expect(order('name', false)).toEqual(['Drum', 'Pixel', 'Robot', 'Worker']);
    expect(order('in', true)[0]).toBe('Drum');
    expect(order('trip', true)).toEqual(['Pixel', 'Worker', 'Drum', 'Robot']);
    expect(order('trip', false)).toEqual(['Worker', 'Pixel', 'Drum', 'Robot']);
  });

  it('puts what is broken first when it goes by state', () => {
    expect(order('state', false)[0]).toBe('Drum');
    expect(order('state', false).at(-1)).toBe('Robot');
  });
});

describe('the address', () => {
  it('is empty for what is as ever', () => {
    expect(writeWishes(NO_WISHES)).toEqual({});
    expect(readWishes({})).toEqual(NO_WISHES);
  });

  it('comes back as it was written', () => {
    const wishes: ClientWishes = {
      text: 'pad',
      state: 'silent',
      kind: 'phone',
      master: 'hall',
      isBroken: true,
      sort: 'queue',
      isDescending: false,
      view: 'load',
    };
    expect(readWishes(writeWishes(wishes))).toEqual(wishes);
    expect(readWishes({ sort: 'queue' }).isDescending).toBe(true);
  });

  it('leaves out what it does not understand', () => {
    const odd = {
      state: 'x',
      kind: '__proto__',
      sort: 'constructor',
      order: 'up',
      view: '',
      q: [1],
    };
    expect(readWishes(odd)).toEqual(NO_WISHES);
    expect(readWishes({ state: 'toString' }).state).toBeUndefined();
  });
});
