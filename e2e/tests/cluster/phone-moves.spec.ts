import { expect, type Page } from '@playwright/test';
import type { MasterProcess } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';
import { test } from '../../fixtures/cluster.ts';
import { GathererPage, TouchedPhone } from '../../pages/gatherer-page.ts';
import { FROM_ELSEWHERE, JoinPage } from '../../pages/join-page.ts';
import { makeGrant } from '../connect/make-grant.ts';

const DEVICE = 'web-interface-smart-device';
/** Console messages of the browser itself, before joining and while the master is gone. */
const EXPECTED = [/status of (401|403)/, /net::ERR_/, /WebSocket connection to .* failed/];

/**
 * Makes a page a stranger for its master, as the page of a phone is: this computer's own is an admin, and leaves the join
 * page without a tap. Another master would refuse the header of requests from this origin.
 */
async function comeFromElsewhere(page: Page, { url }: MasterProcess): Promise<void> {
  await page.route(`${url}/**`, (route, request) =>
    route.continue({ headers: { ...request.headers(), ...FROM_ELSEWHERE.extraHTTPHeaders } }),
  );
}

test('a phone goes on at another master when its own is killed, and so does the session that it feeds [CU-32] [CU-83] [CU-92]', async ({
  cluster,
}) => {
  test.slow();
  const [north, south] = cluster.masters;
  const stage = new GathererPage((await cluster.atDesk(north, 'Stage')).page);
  await stage.open();
  await stage.start(); // at this master, which owns the session now
  await stage.page.close();
  const balcony = new GathererPage((await cluster.atDesk(south, 'Balcony')).page);
  await balcony.open();
  await balcony.expectSession('Running');

  const phone = await cluster.withPhone(north, 'Mara');
  phone.watch.expect(...EXPECTED, new RegExp(`^request to ${south.url}/`));
  const { page } = phone;
  const { token } = await makeGrant(north, {
    role: AccessRole.ACCESS_ROLE_PLAYER,
    target: '/devices/smart-device',
  });
  await TouchedPhone.preparing(phone);
  await comeFromElsewhere(page, north);
  await page.goto(`/join#${token}`);
  await new JoinPage(phone).join.tap();
  const mara = await TouchedPhone.of(phone);
  await page.unrouteAll({ behavior: 'wait' });
  await balcony.expectPhones('Mara');
  const id = await balcony.idOf('Mara');

  // Another finger, of a program at the other master
  const ben = await cluster.program(south, 'Ben');
  const touches = setInterval(() => {
    ben.publish(`/${ben.id}/${DEVICE}/touch_position`, 'vector2', { x: 0.33, y: 0.32 });
  }, 200);
  try {
    await mara.touch([0.3, 0.3]);
    await expect(mara.flash).toBeVisible();
    await mara.lift();
    await expect(mara.flash).toHaveCount(0);

    await test.step('its master dies: it moves, and says so', async () => {
      await north.kill();
      await expect(page.getByText(`Moved to ${new URL(south.url).host}.`)).toBeVisible();
      await balcony.expectPhones('Mara');
      expect(await balcony.idOf('Mara')).toBe(id);
    });

    await test.step('its finger is seen by others, and felt by the session, which goes on', async () => {
      await balcony.expectSession('Running');
      await mara.touch([0.32, 0.31]);
      await expect(balcony.touches).toHaveCount(1);
      await expect(mara.flash).toBeVisible();
      await expect(balcony.phone('Mara')).toContainText('Near');
      const { elements } = await ben.call('deviceGetList', { elements: [{ name: DEVICE }] });
      expect(elements.map(({ clientId }) => clientId)).toEqual([id]);
      await mara.lift();
    });

    await test.step('it opens its page there, as who it is, and can be loaded again [CU-97]', async () => {
      await page.getByRole('button', { name: 'Open at new address' }).tap();
      await expect(page).toHaveURL(`${south.url}/devices/smart-device`);
      for (const _ of ['opened', 'loaded again']) {
        const there = await TouchedPhone.of(phone);
        await balcony.expectPhones('Mara');
        expect(await balcony.idOf('Mara')).toBe(id);
        await there.touch([0.3, 0.3]);
        await expect(there.flash).toBeVisible();
        await there.lift();
        await page.reload();
      }
    });
  } finally {
    clearInterval(touches);
  }
});
