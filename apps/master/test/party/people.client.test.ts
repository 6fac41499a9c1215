import type { FakeAssets } from '@ubii/pm-sandbox/testing';
import { AccessRole } from '@ubii/proto';
import { phoneTopic, PLAYER_READS, stateTopic } from '@ubii/party/net';
import { afterEach, beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { createGrant } from '../access-world.ts';
import { buildPartyLibrary, PartyWorld, type ScriptedPhone } from './party-world.ts';

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

async function startRound(...games: string[]): Promise<readonly [ScriptedPhone, ScriptedPhone]> {
  const mara = await party.addPhone('Mara');
  const theo = await party.addPhone('Theo');
  party.host.apply({ type: 'set-games', by: 'host', games });
  await party.playTo('play');
  return [mara, theo];
}

/** The components that a client has topics of, also those it only says it has. */
async function componentsOf({ client }: ScriptedPhone): Promise<string[]> {
  const topics = await party.world.test.call({ topic: '/services/topic_list' });
  const devices = await party.world.test.call({ topic: '/services/device/get_list' });
  const named = (devices.deviceList?.elements ?? [])
    .filter(({ clientId }) => clientId === client.id)
    .flatMap(({ components }) => components.map(({ topic }) => topic));
  const prefix = `/${client.id}/party/`;
  const all = [...(topics.stringList?.elements ?? []), ...named]
    .filter((topic) => topic.startsWith(prefix))
    .map((topic) => topic.slice(prefix.length));
  return [...new Set(all)].sort();
}

describe('a spectator', () => {
  it('sees who plays, the round and the table, and is waited for by nobody', async () => {
    const [mara] = await startRound('hill', 'duel');
    const wim = await party.addSpectator('Wim');
    await party.until(() => wim.phone.facts.live !== undefined);
    const { live, spectator, feedback } = wim.phone.facts;
    expect(spectator?.name).toBe('Wim');
    expect(feedback).toBeUndefined();
    expect(live!.headline).toMatch(/standing$/);
    expect(live!.rows.map(({ seat }) => seat).sort()).toEqual([0, 1]);
    expect(live!.rows[0]).toMatchObject({ place: 1, isOut: false });
    expect(live!.rows[0]!.note).toMatch(/\d/);
    expect(mara.phone.facts.live).toBeUndefined();

    party.phones.pop();
    await party.playTo('end');
    expect(wim.phone.facts.view?.room.results.map(({ game }) => game)).toEqual(['hill', 'duel']);
    for (const { places } of party.room.results) expect(places.flat().sort()).toEqual([0, 1]);
    expect(wim.phone.facts.spectator?.name).toBe('Wim');
    expect(party.troubles).toEqual([]);
  }, 60_000);

  it('keeps watching through a reload, and is gone when the phone was away for two minutes', async () => {
    const wim = await party.addSpectator('Wim');
    wim.phone.close();
    wim.client.leave();
    await party.until(() => party.room.spectators[0]?.awaySinceMs !== undefined);
    await party.connectPhone(wim);
    await party.pass(1500);
    expect(party.room.spectators).toEqual([{ key: wim.client.id, name: 'Wim' }]);
    wim.phone.close();
    await party.until(() => party.room.spectators.length === 0);
  });

  it('watches a locked game, and takes a seat when it is open again', async () => {
    const [mara] = await startRound('duel', 'hill');
    await party.ask(mara, { type: 'lock', on: true });
    const wim = await party.addSpectator('Wim');
    await expect(party.ask(wim, { type: 'join', name: 'Wim' })).rejects.toThrow('locked');
    expect(party.room.spectators).toHaveLength(1);
    await party.ask(mara, { type: 'lock', on: false });
    await party.ask(wim, { type: 'join', name: 'Wim' });
    expect(party.room.spectators).toEqual([]);
    expect(wim.phone.facts.me).toMatchObject({ seat: 2, isWaiting: true });
    await party.playTo('podium');
    expect(party.room.results[0]!.places.flat()).not.toContain(2);
    await party.playTo('play');
    await party.pass(2000);
    expect(wim.phone.facts.feedback?.of).toBe(3);
  }, 60_000);

  it('is removed by the leader, and by nobody else who plays', async () => {
    const [mara, theo] = await startRound('hill');
    const wim = await party.addSpectator('Wim');
    const key = wim.client.id;
    await expect(party.ask(theo, { type: 'dismiss', key })).rejects.toThrow('Mara leads');
    await party.ask(mara, { type: 'dismiss', key });
    expect(wim.phone.facts.spectator).toBeUndefined();
    expect(party.room.spectators).toEqual([]);
  });

  it('has topics for what watching takes, and more only with a seat', async () => {
    const watching = ['cheer', 'here', 'reply', 'request'];
    const [mara] = await startRound('hill');
    const wim = await party.addSpectator('Wim');
    wim.phone.steer(1, 0);
    wim.phone.press(true);
    wim.phone.answer({ text: 'cup', score: 1, atMs: wim.phone.facts.nowMs() });
    await party.pass(500);
    expect(await componentsOf(wim)).toEqual(watching);
    expect(await componentsOf(mara)).toEqual(expect.arrayContaining(['stick', 'button']));
    await party.ask(wim, { type: 'join', name: 'Wim' });
    await party.pass(200);
    expect(await componentsOf(wim)).toEqual(
      expect.arrayContaining([...watching, 'stick', 'button', 'answer', 'photo']),
    );
    await party.ask(wim, { type: 'leave' });
    await party.pass(1500);
    expect(await componentsOf(wim)).toEqual(watching);
  });

  it('leads nothing and reads no more than the room and the round in words', async () => {
    const { token } = await createGrant(party.world.test, AccessRole.ACCESS_ROLE_PLAYER, {
      readTopics: [...PLAYER_READS],
    });
    await startRound('hill');
    const wim = await party.addSpectator('Wim', { joinToken: token });
    await party.until(() => wim.phone.facts.live !== undefined);
    expect(wim.problems).toEqual([]);
    const told: unknown[] = [];
    const states = wim.client.subscribe(stateTopic('hill'));
    states.ready.catch(() => undefined);
    states.onRecord((record) => told.push(record));
    const before = party.room;
    for (const wish of [
      { type: 'proceed' },
      { type: 'kick', seat: 0 },
      { type: 'set-pace', pace: 'long' },
      { type: 'lock', on: true },
      { type: 'offer' },
    ] as const)
      await expect(party.ask(wim, wish)).rejects.toThrow();
    await party.ask(wim, { type: 'ready', isReady: true });
    expect({ ...party.room, endsAtMs: 0 }).toEqual({ ...before, endsAtMs: 0 });
    expect(told).toEqual([]);
  });
});

describe('cheering', () => {
  it('comes to the big screen with the seat of a late joiner, once', async () => {
    await startRound('hill');
    const lin = await party.addPhone('Lin');
    await party.until(() => lin.phone.facts.live !== undefined);
    lin.phone.cheer('hooray');
    await party.pass(100);
    const cheer = { kind: 'hooray', key: lin.client.id, name: 'Lin', seat: 2 };
    expect(party.cheers).toEqual([cheer]);
    await party.pass(1500);
    party.closeScreen();
    await party.openScreen();
    expect(party.cheers).toEqual([cheer]);
  });

  it('in a flood is dropped and counted, and the cheers of others come through', async () => {
    await startRound('hill');
    const lin = await party.addPhone('Lin');
    const wim = await party.addSpectator('Wim');
    const stranger = await party.world.connect('stranger');
    for (let i = 0; i < 300; i += 1) {
      lin.phone.cheer('love');
      for (const text of ['boo', '', '{', 'x'.repeat(5000)])
        lin.client.publish(phoneTopic(lin.client.id, 'cheer'), 'string', text);
      const { client } = stranger;
      client.publish(phoneTopic(client.id, 'cheer'), 'string', 'love');
    }
    await party.pass(300);
    const shown = party.cheers.filter(({ key }) => key === lin.client.id);
    expect(shown.length).toBeGreaterThan(0);
    expect(shown.length).toBeLessThanOrEqual(3);
    expect(party.host.droppedCheers).toBeGreaterThan(0);
    wim.phone.cheer('nice');
    await party.pass(100);
    expect(party.cheers.at(-1)).toEqual({ kind: 'nice', key: wim.client.id, name: 'Wim' });
    expect(party.cheers.every(({ key }) => key !== stranger.client.id)).toBe(true);
  });

  it('does not count in the lobby', async () => {
    const mara = await party.addPhone('Mara');
    mara.phone.cheer('nice');
    await party.pass(200);
    expect(party.cheers).toEqual([]);
    expect(party.host.droppedCheers).toBe(0);
  });
});

it('words of a round are not told while all play, and are gone with the round', async () => {
  const topics = async (): Promise<readonly string[]> =>
    (await party.world.test.call({ topic: '/services/topic_list' })).stringList?.elements ?? [];
  const [mara] = await startRound('hill');
  await party.pass(2000);
  expect(await topics()).not.toContain('/party/live');
  await party.addSpectator('Wim');
  await party.pass(1000);
  expect(await topics()).toContain('/party/live');
  party.phones.pop();
  await party.playTo('end');
  await party.ask(mara, { type: 'proceed' });
  await party.pass(1500);
  expect(await topics()).not.toContain('/party/live');
}, 60_000);
