import type { FakeAssets } from '@ubii/pm-sandbox/testing';
import { phoneTopic } from '@ubii/party/net';
import type { DuelState } from '@ubii/party/sim';
import { afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { buildPartyLibrary, PartyWorld, type ScriptedPhone } from './party-world.ts';
import { clockAhead, type Line } from './slow-line.ts';

const OFF_MS = 3000;
/** The master measures each phone at least so often, and keeps a minute. */
const MEASURED_AFTER_MS = 65_000;

let library: FakeAssets;
let party: PartyWorld;

beforeAll(async () => {
  library = await buildPartyLibrary();
});
beforeEach(() => {
  party = new PartyWorld(library);
});
afterEach(() => party.close());

/** A line whose packets all take as long. @param roundTripMs there and back */
const steady = (roundTripMs: number): Line => ({
  toMasterMs: () => roundTripMs / 2,
  toPhoneMs: () => roundTripMs / 2,
});

const nowMs = (): number => party.world.clock.nowMs();
const duel = (): DuelState => party.states.at(-1)!.state.state as DuelState;

describe('a press in Quick Draw', () => {
  async function startDuel(...lines: readonly Line[]): Promise<readonly ScriptedPhone[]> {
    await party.openScreen();
    const phones: ScriptedPhone[] = [];
    let isJoined = false;
    for (const [index, { toMasterMs, toPhoneMs }] of lines.entries()) {
      const line: Line = {
        toMasterMs: () => (isJoined ? toMasterMs() : 0),
        toPhoneMs: () => (isJoined ? toPhoneMs() : 0),
      };
      phones.push(await party.addPhone(`P${index}`, { line }));
    }
    isJoined = true;
    party.host.apply({ type: 'set-games', by: 'host', games: ['duel'] });
    await party.pass(MEASURED_AFTER_MS);
    await party.playTo('play');
    await party.until(() => party.states.length > 0);
    // From now on they press when the test says
    for (const phone of phones) phone.isAsleep = true;
    return phones;
  }

  /** Lets time pass until so long after the flag of this bout. */
  async function waitAfterFlag(afterMs: number): Promise<void> {
    const { startsAtMs } = party.view.round!;
    const atMs = startsAtMs + duel().bout.signalAtMs + afterMs;
    await party.until(() => nowMs() >= atMs - 100);
    await party.pass(atMs - nowMs());
  }

  /** The button as a changed program publishes it: with any time. */
  function claim({ client }: ScriptedPhone, atMs: number): void {
    client.publish(phoneTopic(client.id, 'pressed'), 'double', atMs, { immediate: true });
  }

  async function decided(): Promise<DuelState['decided'][number]> {
    await party.until(() => duel().decided.length > 0);
    return duel().decided[0]!;
  }

  it('is judged by when it was, with 150 ms lag beside 5 ms', async () => {
    const [mara, theo] = await startDuel(steady(150), steady(5));
    await waitAfterFlag(200);
    const pressedMs = nowMs() - party.view.round!.startsAtMs - duel().bout.signalAtMs;
    mara!.phone.press(true);
    await party.pass(40);
    theo!.phone.press(true);
    const { winner, reactionMs } = await decided();
    expect(winner).toBe(0);
    expect(Math.abs(reactionMs! - pressedMs)).toBeLessThan(10);
    expect(party.view.lags[0]).toBeGreaterThanOrEqual(150);
  });

  it('counts fairly when its packet is suddenly slow, as slow as the lag has varied', async () => {
    let count = 0;
    let isSlow = false;
    const toMasterMs = (): number => (isSlow ? 60 : 20 + ((count += 1) % 3) * 20);
    const varying = { ...steady(40), toMasterMs };
    const [mara, theo] = await startDuel(varying, steady(5));
    await waitAfterFlag(200);
    isSlow = true;
    mara!.phone.press(true);
    await party.pass(25);
    theo!.phone.press(true);
    expect((await decided()).winner).toBe(0);
  });

  it('cannot be claimed 400 ms earlier than it came over a fast line', async () => {
    const [mara, theo] = await startDuel(steady(5), steady(5));
    await waitAfterFlag(200);
    mara!.phone.press(true);
    await party.pass(400);
    claim(theo!, nowMs() - 400 - 50);
    const { winner, reactionMs } = await decided();
    expect(winner).toBe(0);
    expect(reactionMs).toBeGreaterThan(190);
    expect(duel().decided).toHaveLength(1);
  });
});

describe('the start of a round', () => {
  it.each([
    ['the big screen', { screen: OFF_MS, machine: 0, phone: 0 }],
    ['the big screen, behind', { screen: -OFF_MS, machine: 0, phone: 0 }],
    ['the machine that the game runs on', { screen: 0, machine: OFF_MS, phone: 0 }],
    ['a phone', { screen: 0, machine: 0, phone: -OFF_MS }],
  ])('is by the time of the master when a clock is 3 s off: %s', async (_who, off) => {
    const { clock } = party.world;
    vi.spyOn(Date, 'now').mockImplementation(() => nowMs() + off.machine);
    await party.openScreen({ clock: clockAhead(clock, off.screen) });
    const mara = await party.addPhone('Mara', { clock: clockAhead(clock, off.phone) });
    await party.addPhone('Theo');
    await party.playTo('countdown');
    const beganMs = nowMs();
    const { startsAtMs } = party.view.round!;
    expect(Math.abs(startsAtMs - beganMs - 3000)).toBeLessThan(100);
    expect(Math.abs(mara.phone.facts.nowMs() - beganMs)).toBeLessThan(5);
    await party.until(() => party.states.length > 0);
    const firstMs = nowMs() - (party.states[0]!.state.step * 1000) / 60;
    expect(Math.abs(firstMs - startsAtMs)).toBeLessThan(100);
  });
});
