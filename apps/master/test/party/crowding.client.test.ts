import type { FakeAssets } from '@ubii/pm-sandbox/testing';
import { MAX_SEATS, MAX_SPECTATORS } from '@ubii/party/sim';
import { afterEach, beforeAll, beforeEach, expect, it } from 'vitest';
import { buildPartyLibrary, PartyWorld } from './party-world.ts';

let library: FakeAssets;
let party: PartyWorld;

beforeAll(async () => {
  library = await buildPartyLibrary();
});
beforeEach(async () => {
  party = new PartyWorld(library);
  await party.openScreen();
});
afterEach(() => party.close());

/** The address of one person with many clients, and those of others. */
const CROWD = { address: '192.168.1.66' };
const MARA = { address: '192.168.1.7' };
const THEO = { address: '192.168.1.8' };

/** Takes all places but `free`, as clients of unknown addresses. */
function takeAllBut(free: number, type: 'join' | 'watch'): void {
  const max = type === 'join' ? MAX_SEATS : MAX_SPECTATORS;
  for (let index = 0; index < max - free; index++)
    party.host.apply({ type, key: `other${index}`, name: '' });
}

it('gives a new client a seat of the address that has most, and that address none back', async () => {
  takeAllBut(2, 'join');
  const first = await party.addPhone('First', CROWD);
  const second = await party.addPhone('Second', CROWD);
  await expect(party.addPhone('Third', CROWD)).rejects.toThrow('All 32 seats are taken.');
  const mara = await party.addPhone('Mara', MARA);
  expect(party.room.players).toHaveLength(MAX_SEATS);
  expect(party.seatOf(mara)).toBe(31);
  expect(party.seatOf(first)).toBe(30);
  expect(party.seatOf(second)).toBeUndefined();
  await expect(party.ask(second, { type: 'join', name: 'Second' })).rejects.toThrow('are taken');
  await expect(party.addPhone('Theo', THEO)).rejects.toThrow('All 32 seats are taken.');
});

it('gives no seat of a locked game', async () => {
  takeAllBut(2, 'join');
  await party.addPhone('First', CROWD);
  await party.addPhone('Second', CROWD);
  party.host.apply({ type: 'lock', by: 'host', on: true });
  await expect(party.addPhone('Mara', MARA)).rejects.toThrow('The game is locked.');
  expect(party.room.players).toHaveLength(MAX_SEATS);
});

it('shares out the places to watch likewise', async () => {
  takeAllBut(2, 'watch');
  const first = await party.addSpectator('First', CROWD);
  await party.addSpectator('Second', CROWD);
  await expect(party.addSpectator('Third', CROWD)).rejects.toThrow('limit of 64 spectators');
  const mara = await party.addSpectator('Mara', MARA);
  const keys = party.room.spectators.slice(-2).map(({ key }) => key);
  expect(keys).toEqual([first.client.id, mara.client.id]);
});

it('keeps players who are here, however many clients without a place say that they are', async () => {
  const { client } = await party.world.connect('crowd');
  for (let index = 0; index < 200; index++)
    client.publish(`/ghost${index}/party/here`, 'double', 1);
  await party.pass(500);
  const mara = await party.addPhone('Mara', MARA);
  await party.pass(6000);
  expect(party.seatOf(mara)).toBe(0);
  expect(party.room.players[0]!.awaySinceMs).toBeUndefined();
});
