import type { Page } from '@playwright/test';
import type { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { callService } from '../fixtures/call-service.ts';
import { expect, test } from '../fixtures/test.ts';
import { SessionPage } from '../pages/session-page.ts';
import { Shell } from '../pages/shell.ts';
import { DEVICE, lampSession } from './lamp-session.ts';
import { layOver, SCALE } from './lay-over.ts';
import { MovedPhone } from './moved-phone.ts';
import { pictureFile } from './picture-file.ts';

/** What is seen moves, as for most people. */
const LIVELY = { reducedMotion: 'no-preference' } as const;

test.use({ masterStart: { flags: ['--name', 'Studio'] } });

test('a session takes the touches of a phone and gives it colour', async ({
  browser,
  master,
  room,
}) => {
  const phone = await MovedPhone.open(
    await room.withPhone('Mara', {
      ...LIVELY,
      colorScheme: 'light',
      viewport: { width: 400, height: 820 },
    }),
  );
  const desk = await room.atDesk('Sam', {
    ...LIVELY,
    colorScheme: 'dark',
    viewport: { width: 1168, height: 728 },
    deviceScaleFactor: SCALE,
  });
  const session = new SessionPage(desk);
  await desk.page.goto(`/sessions/${await lampSession(master, await idOfPhone(master))}`);
  await session.act('Start');
  await session.expectState('Running');
  await new Shell(desk.page).expectConnected();
  await leaveRoomOnTheRight(desk.page);
  // The charts of the last seconds are full, and the colour is that of an amber lamp
  await phone.move(134);
  await expect(session.graph.life).not.toContainText('problem');
  await layOver(
    browser,
    await desk.page.screenshot(),
    [await phone.page.screenshot()],
    pictureFile('session-graph'),
  );
});

/** Shows the graph smaller, to the left of where the phone will lie. */
async function leaveRoomOnTheRight({ mouse }: Page): Promise<void> {
  await mouse.move(240, 620);
  await mouse.wheel(0, 60);
  await mouse.down();
  await mouse.move(170, 620, { steps: 5 });
  await mouse.up();
}

/** The id of the only phone. */
async function idOfPhone(master: MasterProcess): Promise<string> {
  const request = {
    topic: SERVICES.deviceGetList.topic,
    deviceList: { elements: [{ name: DEVICE }] },
  };
  const ask = async () => (await callService(master.endpoints, request)).deviceList?.elements ?? [];
  await expect.poll(ask).toHaveLength(1);
  return (await ask())[0]!.clientId;
}
