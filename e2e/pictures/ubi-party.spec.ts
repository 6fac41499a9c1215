import { stateTopic } from '@ubii/party/net';
import type { RoundState } from '@ubii/party/modules';
import { GAMES, type Game } from '@ubii/party/sim';
import { expect, test } from '../fixtures/test.ts';
import { PartyPhonePage, PartyScreenPage } from '../pages/party-pages.ts';
import { layOver, SCALE } from './lay-over.ts';
import { pictureFile } from './picture-file.ts';

const NAMES = ['Mara', 'Theo', 'Ines'] as const;
const UNPLAYED = ['Photo Hunt', 'Marble Dash'] as const;
/** Steps of the round in the picture: all stand, and have moved. */
const FROM_STEP = 150;
/** What is seen moves, as for most people. */
const LIVELY = { reducedMotion: 'no-preference', deviceScaleFactor: SCALE } as const;

test('three phones play King of the Hill with their sticks', async ({ browser, room }) => {
  test.setTimeout(300_000);
  const { page } = await room.atDesk('Big screen', {
    ...LIVELY,
    viewport: { width: 1224, height: 688 },
  });
  const screen = new PartyScreenPage(page);
  await page.goto('/party');
  const phones: PartyPhonePage[] = [];
  for (const name of NAMES) {
    const viewport = { width: 390, height: 760 };
    const person = await room.withPhone(name, { ...LIVELY, viewport });
    const phone = new PartyPhonePage(person.page, name);
    await phone.join();
    phones.push(phone);
  }
  await screen.expectPlayers(NAMES.length);

  const eyes = await room.program('eyes');
  let newest: RoundState | undefined;
  const states = eyes.subscribe(stateTopic('hill'), { format: 'string' });
  states.onRecord(({ value }) => (newest = JSON.parse(value) as RoundState));
  await states.ready;

  for (const game of UNPLAYED) await page.getByRole('button', { name: game }).click();
  await screen.start();
  await screen.expectPhase('explanation');
  for (const phone of phones) await phone.ready();
  await screen.expectPhase('play');

  // Thumbs do what the game's own bots would
  const rules = GAMES.hill as unknown as Game<unknown>;
  while (newest === undefined || newest.step < FROM_STEP) {
    const now = newest;
    for (const [seat, phone] of now ? phones.entries() : []) {
      const { x, y } = rules.bot(now!.state, seat);
      await phone.steer(x, y);
    }
    await page.waitForTimeout(30);
  }
  await expect(page.getByText('3 standing')).toBeVisible();
  // Where the processor draws the stage, its picture takes longer than the round
  const round = (await eyes.call('sessionRuntimeGetList')).elements.find(({ name }) =>
    name.startsWith('Ubi-Party'),
  )!;
  await eyes.call('sessionPause', round);
  const desk = await page.screenshot();
  const hands = await Promise.all(phones.map((phone) => phone.page.screenshot()));
  await screen.expectPhase('play', 1);
  await eyes.call('sessionResume', round);
  await layOver(browser, desk, hands, pictureFile('ubi-party'));
  for (const phone of phones) await phone.release();
});
