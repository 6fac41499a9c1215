import type { FakeAssets } from '@ubii/pm-sandbox/testing';
import { createMemoryIdentity } from '@ubii/client-web/node';
import { AccessRole } from '@ubii/proto';
import {
  phoneTopic,
  PLAYER_READS,
  ROOM_TOPIC,
  ROUND_TOPIC,
  SEATS_TOPIC,
  settingTopic,
  stateTopic,
} from '@ubii/party/net';
import { afterEach, beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { createGrant } from '../access-world.ts';
import { buildPartyLibrary, PartyWorld } from './party-world.ts';
import type { Line } from './slow-line.ts';

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

async function addPhones(...names: string[]) {
  const phones = [];
  for (const name of names) phones.push(await party.addPhone(name));
  return phones;
}

describe('a party', () => {
  it('is a tournament that phones play to its end, and nobody is lost', async () => {
    await addPhones('Mara', 'Theo', 'Ines', 'Jo');
    party.host.apply({ type: 'set-games', by: 'host', games: ['hill', 'duel'] });
    await party.playTo('end');
    const { results, players } = party.room;
    expect(results.map(({ game }) => game)).toEqual(['hill', 'duel']);
    for (const { game, state } of party.states) expect(state.id.split('-')[0]).toBe(game);
    for (const { places } of results) expect(places.flat().sort()).toEqual([0, 1, 2, 3]);
    for (const { seat, points } of players) {
      const sum = results.reduce((total, result) => total + (result.points[seat] ?? 0), 0);
      expect(points).toBe(sum);
    }
    expect(party.troubles).toEqual([]);
  }, 120_000);

  it('plays each game in a session that can be opened, and leaves none behind', async () => {
    await addPhones('Mara', 'Theo');
    await party.playTo('play');
    await party.pass(500);
    const { sessionList } = await party.world.test.call({
      topic: '/services/session/runtime/get_list',
    });
    expect(sessionList?.elements.map(({ name }) => name)).toEqual(['Ubi-Party: Marble Dash']);
    expect(party.view.round?.sessionId).toBe(sessionList?.elements[0]?.id);
    await party.host.end();
    await party.pass(100);
    const after = await party.world.test.call({ topic: '/services/session/runtime/get_list' });
    expect(after.sessionList?.elements ?? []).toEqual([]);
  });

  it('says to each phone how its player stands', async () => {
    const [mara] = await addPhones('Mara', 'Theo');
    await party.playTo('play');
    await party.pass(2000);
    expect(mara!.phone.facts.feedback).toMatchObject({ of: 2, headline: 'Lap 1 of 3' });
  });
});

describe('a player', () => {
  it('keeps seat and points through a reload, and is back within two seconds', async () => {
    const [, theo] = await addPhones('Mara', 'Theo');
    const seat = party.seatOf(theo!);
    theo!.phone.close();
    theo!.client.leave();
    await party.until(() => party.room.players[1]?.awaySinceMs !== undefined);
    await party.connectPhone(theo!);
    await party.pass(1500);
    expect(party.seatOf(theo!)).toBe(seat);
    expect(party.room.players[1]?.awaySinceMs).toBeUndefined();
  });

  it('who sleeps holds up no round', async () => {
    const [, theo] = await addPhones('Mara', 'Theo');
    party.host.apply({ type: 'set-games', by: 'host', games: ['duel'] });
    await party.playTo('explanation');
    theo!.isAsleep = true;
    theo!.phone.setSeen(false);
    await party.pass(200);
    await party.playTo('end');
    expect(party.room.results[0]?.places).toEqual([[0], [1]]);
  }, 60_000);

  it('hands the seat over to another phone with a code, once', async () => {
    const [mara, theo] = await addPhones('Mara', 'Theo');
    const { code } = await party.ask(mara!, { type: 'offer' });
    const other = await party.addPhone('Other');
    await party.ask(other, { type: 'leave' });
    await party.ask(other, { type: 'take', code: code!.toLowerCase() });
    expect(party.seatOf(other)).toBe(0);
    expect(party.seatOf(mara!)).toBeUndefined();
    await expect(party.ask(mara!, { type: 'take', code: code! })).rejects.toThrow(
      'This code is not valid any more',
    );
    expect(party.seatOf(theo!)).toBe(1);
  });

  it('is refused what only the leader may do, with who leads', async () => {
    const [, theo] = await addPhones('Mara', 'Theo');
    await expect(party.ask(theo!, { type: 'lock', on: true })).rejects.toThrow('Mara leads');
  });

  it('who floods the host with wishes is held back, the others are not', async () => {
    const [mara, theo] = await addPhones('Mara', 'Theo');
    for (let i = 0; i < 2000; i += 1) {
      const text = i % 2 === 0 ? '{"number":1,"wish":{"type":"constructor"}}' : '}'.repeat(5000);
      mara!.client.publish(`/${mara!.client.id}/party/request`, 'string', text);
      void mara!.phone.ask({ type: 'ready', isReady: i % 2 === 0 }).catch(() => undefined);
      mara!.phone.steer(Number.NaN, 1e300);
    }
    await party.pass(200);
    await party.ask(theo!, { type: 'ready', isReady: true });
    expect(party.room.players[1]?.isReady).toBe(true);
    expect(party.room.players).toHaveLength(2);
  });
});

it('nobody is stopped by what is no state, room, feedback or answer', async () => {
  const [mara] = await addPhones('Mara', 'Theo');
  await party.playTo('play');
  const { client } = await party.world.connect('somebody');
  const own = (component: 'feedback' | 'reply') => phoneTopic(mara!.client.id, component);
  for (const topic of [stateTopic('race'), ROOM_TOPIC, own('feedback'), own('reply')])
    for (const text of ['{', 'null', '[]', '"text"', '{"id":1}', '{"room":{"players":7}}'])
      client.publish(topic, 'string', text);
  await party.pass(1500);
  expect(party.room.phase).toBe('play');
  expect(mara!.phone.facts.feedback?.headline).toBe('Lap 1 of 3');
  expect(mara!.phone.facts.me?.name).toBe('Mara');
});

describe('a phone that joined as a player', () => {
  async function addPlayers(...names: string[]) {
    const { token } = await createGrant(party.world.test, AccessRole.ACCESS_ROLE_PLAYER, {
      readTopics: [...PLAYER_READS],
    });
    const players = [];
    for (const name of names) players.push(await party.addPhone(name, { joinToken: token }));
    return players;
  }

  it('has all that a game takes', async () => {
    const players = await addPlayers('Mara', 'Theo');
    expect(players.map(({ client }) => client.role)).toEqual(['player', 'player']);
    party.host.apply({ type: 'set-games', by: 'host', games: ['duel'] });
    await party.playTo('play');
    await party.pass(1500);
    expect(players[0]!.phone.facts.feedback?.headline).toBe('Flag 1 of 5');
    await party.playTo('end');
    expect(party.room.results[0]!.places.flat().sort()).toEqual([0, 1]);
    for (const { problems } of players) expect(problems).toEqual([]);
  }, 60_000);

  it('can neither speak for others nor for the big screen, nor read what others say', async () => {
    const [mara, theo] = await addPlayers('Mara', 'Theo');
    await party.playTo('play');
    const before = party.view.round?.id;
    const { client } = mara!;
    const told: unknown[] = [];
    for (const topic of [`/${theo!.client.id}/party/stick`, stateTopic('race'), SEATS_TOPIC]) {
      const subscription = client.subscribe(topic);
      subscription.ready.catch(() => undefined);
      subscription.onRecord((record) => told.push(record));
    }
    for (const topic of [ROOM_TOPIC, ROUND_TOPIC, SEATS_TOPIC, settingTopic('race', 'speed')])
      client.publish(topic, 'string', '{}');
    client.publish(
      `/${theo!.client.id}/party/request`,
      'string',
      '{"number":1,"wish":{"type":"leave"}}',
    );
    client.publish(`/${theo!.client.id}/party/button`, 'bool', true);
    await party.pass(1000);
    expect(told).toEqual([]);
    expect(party.room.players).toHaveLength(2);
    expect(party.view.round?.id).toBe(before);
    expect(party.superseded).toEqual([]);
    expect(mara!.problems.length).toBeGreaterThan(0);
  });
});

describe('the big screen', () => {
  it('goes on after a reload in the middle of a round', async () => {
    await addPhones('Mara', 'Theo');
    await party.playTo('play');
    await party.pass(1500);
    const before = party.view.round!.id;
    const { step } = party.states.at(-1)!.state;
    party.closeScreen();
    await party.openScreen();
    await party.pass(500);
    expect(party.view.round!.id).toBe(before);
    expect(party.states.at(-1)!.state.step).toBeGreaterThan(step);
    expect(party.room.phase).toBe('play');
  });

  it('goes on after a restart of the master, from where the round was', async () => {
    await addPhones('Mara', 'Theo');
    await party.playTo('play');
    await party.pass(1500);
    const { step } = party.states.at(-1)!.state;
    const { players } = party.room;
    await party.world.restart();
    await party.pass(8000);
    const after = party.states.at(-1)!.state;
    expect(after.step).toBeGreaterThan(step);
    expect(after.step).toBeLessThan(step + 60 * 8);
    expect(party.room.players.map(({ seat, name }) => [seat, name])).toEqual(
      players.map(({ seat, name }) => [seat, name]),
    );
    expect(party.room.players.every(({ awaySinceMs }) => awaySinceMs === undefined)).toBe(true);
  }, 60_000);

  it('is taken over by another screen, which knows the room', async () => {
    await addPhones('Mara', 'Theo');
    party.memory = undefined;
    await party.openScreen({ identity: createMemoryIdentity() });
    expect(party.room.players.map(({ name }) => name)).toEqual(['Mara', 'Theo']);
    expect(party.superseded).toHaveLength(1);
  });

  it('leads alone when it began last, whatever the other one sent meanwhile', async () => {
    let delayMs = 0;
    const openScreen = async (line?: Line): Promise<string> => {
      await party.openScreen({ identity: createMemoryIdentity(), ...(line && { line }) });
      return party.host.view.hostId;
    };
    const first = await openScreen({ toMasterMs: () => delayMs, toPhoneMs: () => delayMs });
    expect(party.superseded).toEqual([first]);
    delayMs = 100;
    const { host } = party;
    const stop = party.world.clock.every(20, () =>
      host.apply({ type: 'lock', by: 'host', on: !host.view.room.isLocked }),
    );
    const second = await openScreen();
    await party.pass(3000);
    stop();
    expect(party.superseded).toEqual([first, second]);
    // Again: on the screen that was superseded
    const third = await openScreen();
    await party.pass(3000);
    expect(party.superseded).toEqual([first, second, third]);
  });

  it('takes over what has happened on the screen that led before', async () => {
    const own = party.memory;
    await party.openScreen({ identity: createMemoryIdentity() });
    await addPhones('Mara', 'Theo');
    await party.openScreen({ identity: createMemoryIdentity() });
    party.host.apply({ type: 'fill', by: 'host', players: 3 });
    // Each browser has its own storage
    party.memory = own;
    await party.openScreen({ identity: createMemoryIdentity() });
    expect(party.room.players).toHaveLength(3);
  });

  it('can be left while it opens', async () => {
    const { host, view } = party;
    await host.end();
    const opening = party.openScreen({ identity: createMemoryIdentity() });
    while (party.host === host) await party.world.pass(1);
    party.closeScreen();
    await opening;
    await party.pass(3000);
    expect(party.view).toBe(view);
  });
});

describe('thirty-two phones', () => {
  it('with jitter, drops and sleeps finish a tournament: nobody is lost, the order is right', async () => {
    const names = Array.from({ length: 32 }, (_, index) => `P${index}`);
    const phones = await addPhones(...names);
    party.host.apply({ type: 'set-games', by: 'host', games: ['hill', 'race', 'duel'] });
    await party.playTo('play');
    for (const [index, scripted] of phones.entries()) {
      // Every fourth sleeps through a part of the first game, every fifth loses its connection
      if (index % 4 === 1) {
        scripted.isAsleep = true;
        scripted.phone.setSeen(false);
      }
      if (index % 5 === 2) {
        scripted.phone.close();
        scripted.client.leave();
      }
    }
    await party.pass(5000);
    for (const [index, scripted] of phones.entries()) {
      if (index % 4 === 1) {
        scripted.isAsleep = false;
        scripted.phone.setSeen(true);
      }
      if (index % 5 === 2) await party.connectPhone(scripted);
    }
    await party.playTo('end');
    const { players, results } = party.room;
    expect(players.map(({ name }) => name)).toEqual(names);
    expect(players.filter(({ awaySinceMs }) => awaySinceMs !== undefined)).toEqual([]);
    for (const { places } of results) expect(places.flat()).toHaveLength(32);
    // The table is the sum of the rounds, by the places that the modules told
    for (const { seat, points } of players) {
      expect(points).toBe(results.reduce((sum, one) => sum + (one.points[seat] ?? 0), 0));
    }
    expect(party.troubles).toEqual([]);
  }, 120_000);
});
