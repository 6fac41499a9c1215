import type { FakeAssets } from '@ubii/pm-sandbox/testing';
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

const quiz = () => party.states.at(-1)!.state.state as { step: number; pace?: number };

it('the leader chooses a pace, which holds for the whole game and survives reload and restart', async () => {
  const mara = await party.addPhone('Mara');
  const theo = await party.addPhone('Theo');
  party.host.apply({ type: 'set-games', by: 'host', games: ['quiz', 'hill'] });
  await expect(party.ask(theo, { type: 'set-pace', pace: 'long' })).rejects.toThrow('Mara leads');
  await party.ask(mara, { type: 'set-pace', pace: 'long' });
  party.closeScreen();
  await party.openScreen();
  expect(party.room.pace).toBe('long');

  await party.ask(mara, { type: 'proceed' });
  const explainedAtMs = party.world.clock.nowMs();
  expect(party.room.endsAtMs! - explainedAtMs).toBeGreaterThan(39_000);
  await party.playTo('play');
  await party.until(() => party.states.length > 0);
  expect(quiz().pace).toBe(2);
  await expect(party.ask(mara, { type: 'set-pace', pace: 'normal' })).rejects.toThrow(
    'between rounds only',
  );
  await party.world.restart();
  await party.pass(8000);
  expect(quiz().pace).toBe(2);
  await party.until(() => party.room.phase === 'podium');
  expect(quiz().step).toBe(7 * 24 * 60 - 1);

  await party.ask(mara, { type: 'set-pace', pace: 'normal' });
  await party.playTo('play');
  expect(party.view.round).not.toHaveProperty('pace');
}, 60_000);
