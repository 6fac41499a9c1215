import type { FakeAssets } from '@ubii/pm-sandbox/testing';
import { createMemoryIdentity } from '@ubii/client-web/node';
import { phoneTopic, type Photo } from '@ubii/party/net';
import { THINGS, type HuntState } from '@ubii/party/sim';
import { afterEach, beforeAll, beforeEach, describe, expect, it } from 'vitest';
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

/** Two players in the middle of a hunt, at its first thing. */
async function startHunt(): Promise<readonly [ScriptedPhone, ScriptedPhone]> {
  const mara = await party.addPhone('Mara');
  const theo = await party.addPhone('Theo');
  party.host.apply({ type: 'set-games', by: 'host', games: ['hunt'] });
  await party.playTo('play');
  await party.until(() => hunt().hunt !== undefined);
  return [mara, theo];
}

const hunt = (): HuntState =>
  (party.states.at(-1)?.state.state ?? ({ hunted: [] } as unknown)) as HuntState;

/** A JPEG file of 480 x 270 pixels without tables: a frame of one component, and a scan of zeros. */
function photoAt(atMs: number, bytes = 100): Photo {
  const jpeg = new Uint8Array(bytes);
  const frame = [0xff, 0xc0, 0, 11, 8, 1, 14, 1, 224, 1, 1, 0x11, 0];
  jpeg.set([0xff, 0xd8, ...frame, 0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0]);
  return { jpeg, width: 480, height: 270, atMs };
}

/** Presses the shutter; the phone looks for a while and hands in what it found. */
async function shoot({ phone }: ScriptedPhone, text: string, isShown = false): Promise<number> {
  const atMs = Math.round(phone.facts.nowMs());
  phone.answer({ text: '', score: 0, atMs });
  if (isShown) phone.showPhoto(photoAt(atMs));
  await party.pass(300);
  phone.answer({ text, score: 0.9, atMs });
  await party.pass(200);
  return atMs;
}

const photosOnMaster = (): Promise<readonly string[]> =>
  party.world.test
    .call({ topic: '/services/topic_list' })
    .then(({ stringList }) =>
      (stringList?.elements ?? []).filter((topic) => topic.endsWith('/party/photo')),
    );

describe('a photo hunt', () => {
  it('is played with what phones find; one shows photos, one keeps them private', async () => {
    const [mara, theo] = await startHunt();
    while (party.room.phase === 'play') {
      await party.pass(200);
      const { hunt: now, hunted, decided } = hunt();
      if (decided) {
        const before = hunted.length;
        await party.until(() => hunt().hunted.length > before || party.room.phase !== 'play');
        continue;
      }
      expect(mara.phone.facts.feedback?.question?.text).toBe(now!.label);
      if (hunted.length === 1) await shoot(theo, 'person');
      await shoot(mara, now!.label, true);
      await party.pass(2000);
      await shoot(theo, now!.label);
    }
    expect(party.room.results[0]?.places).toEqual([[0], [1]]);
    expect(hunt().hunted).toHaveLength(5);
    expect(party.shownPhotos.every((keys) => !keys.includes(theo.client.id))).toBe(true);
    expect(party.shownPhotos.some((keys) => keys.includes(mara.client.id))).toBe(true);
    expect(party.troubles).toEqual([]);
  }, 60_000);

  it('tells a phone that its photo is not the thing, and takes the next one', async () => {
    const [mara] = await startHunt();
    const { label } = hunt().hunt!;
    await shoot(mara, 'person');
    expect(mara.phone.facts.feedback).toMatchObject({ isReady: false });
    expect(mara.phone.facts.feedback?.sentence).toContain('The phone recognized: person');
    await party.pass(2000);
    await shoot(mara, label);
    expect(mara.phone.facts.feedback?.sentence).toContain('Found as 1st');
  });

  it('is not decided by answers that nobody with a seat gives', async () => {
    const [, theo] = await startHunt();
    await party.ask(theo, { type: 'leave' });
    const { label } = hunt().hunt!;
    await shoot(theo, label, true);
    // A program that goes on without a seat
    const userDataJson = JSON.stringify({ score: 0.9, atMs: theo.phone.facts.nowMs() });
    theo.client.publish(phoneTopic(theo.client.id, 'answer'), 'object2D', {
      id: label,
      pose: undefined,
      size: undefined,
      userDataJson,
    });
    await party.pass(200);
    expect(hunt().hunt!.photos).toEqual({});
    expect(party.shownPhotos.flat()).toEqual([]);
  });
});

describe('a photo on the big screen', () => {
  it('ends for everybody when the host takes it down, and the next one is shown', async () => {
    const [mara] = await startHunt();
    await shoot(mara, 'person', true);
    expect(party.shownPhotos.at(-1)).toEqual([mara.client.id]);
    expect(await photosOnMaster()).toHaveLength(1);
    party.host.takeDownPhoto(0);
    await party.pass(1500);
    expect(party.shownPhotos.at(-1)).toEqual([]);
    expect(await photosOnMaster()).toEqual([]);
    await party.pass(10_000);
    expect(await photosOnMaster()).toEqual([]);
    await shoot(mara, 'person', true);
    expect(party.shownPhotos.at(-1)).toEqual([mara.client.id]);
  });

  it('is not published while the host hides all', async () => {
    const [mara] = await startHunt();
    await shoot(mara, 'person', true);
    party.host.hidePhotos(true);
    await party.pass(1500);
    expect(await photosOnMaster()).toEqual([]);
    await party.pass(2000);
    await shoot(mara, 'person', true);
    expect(await photosOnMaster()).toEqual([]);
    expect(party.memory?.arePhotosHidden).toBe(true);
  });

  it('stands while the phone says it again, and is gone soon after the phone is', async () => {
    const [mara] = await startHunt();
    await shoot(mara, 'person', true);
    await party.pass(20_000);
    expect(party.shownPhotos.at(-1)).toEqual([mara.client.id]);
    mara.phone.showPhoto(undefined);
    await party.pass(1000);
    expect(await photosOnMaster()).toEqual([]);
  });

  it('is none when it is too large', async () => {
    const [mara] = await startHunt();
    mara.phone.showPhoto(photoAt(Math.round(mara.phone.facts.nowMs()), 60_001));
    await party.pass(500);
    expect(party.shownPhotos.flat()).toEqual([]);
  });
});

describe('the list of things that can be found', () => {
  const others = Object.keys(THINGS).filter((thing) => thing !== 'cup');

  it('survives a reload of the big screen', async () => {
    for (const thing of others) party.host.setSetting('hunt', thing, 0);
    await party.pass(500);
    party.closeScreen();
    await party.openScreen();
    expect(Object.keys(party.room.settings.hunt ?? {}).sort()).toEqual([...others].sort());
    await startHunt();
    expect(hunt().hunt!.label).toBe('cup');
  });

  it('survives a restart of the master, and another screen knows it', async () => {
    for (const thing of others) party.host.setSetting('hunt', thing, 0);
    await party.addPhone('Ines');
    await party.pass(500);
    await party.world.restart();
    await party.pass(8000);
    party.memory = undefined;
    await party.openScreen({ identity: createMemoryIdentity() });
    expect(Object.keys(party.room.settings.hunt ?? {})).toHaveLength(others.length);
    await startHunt();
    expect(hunt().hunt!.label).toBe('cup');
  });

  it('is all things again in the next party', async () => {
    for (const thing of others) party.host.setSetting('hunt', thing, 0);
    await party.pass(500);
    await party.host.end();
    await party.pass(1500);
    const { stringList } = await party.world.test.call({ topic: '/services/topic_list' });
    expect(stringList?.elements.filter((topic) => topic.startsWith('/party/hunt/'))).toEqual([]);
    party.closeScreen();
    await party.openScreen();
    expect(party.room.settings).toEqual({});
  });
});
