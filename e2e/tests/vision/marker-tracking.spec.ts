import type { Locator } from '@playwright/test';
import type { Person } from '../../fixtures/person.ts';
import { expect, test } from '../../fixtures/test.ts';

const EXAMPLE = '/examples/marker-tracking';
const PRINT = '/devices/camera/print-markers';
const A4_POINTS = /\/MediaBox \[0 0 (59[45](?:\.\d+)?) (84[12](?:\.\d+)?)\]/g;

const seen = ({ page }: Person): Locator => page.getByRole('region', { name: 'Markers now' });
const start = ({ page }: Person): Locator =>
  page.getByRole('button', { name: 'Start', exact: true });

test('markers that the page prints are found in a tab and on the master, with the ids they were printed with', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  const anna = await room.atDesk('Anna');
  const { page } = anna;
  await page.goto(PRINT);

  const sheet = await test.step('print page: a sheet in true size', async () => {
    await page.getByRole('combobox', { name: 'Dictionary' }).click();
    await page.getByRole('option', { name: /36h11/ }).click();
    await page.getByLabel('First id').fill('40');
    await page.getByLabel('Last id').fill('44');
    const preview = page.getByRole('img', { name: 'Sheet 1 of 2 with markers' });
    await expect(preview).toContainText('apriltag_36h11:40 · 60 mm');
    const picture = await preview.screenshot();

    await page.emulateMedia({ media: 'print' });
    await expect(page.locator('#app')).toBeHidden();
    const ruler = await page.locator('.printed-sheets [data-ruler]').first().boundingBox();
    // 96 pixels an inch; its box includes the width of the line, 0.25 mm
    expect(ruler!.width).toBeCloseTo((100.25 / 25.4) * 96, 0);
    const pdf = (await page.pdf({ preferCSSPageSize: true })).toString('latin1');
    expect([...pdf.matchAll(A4_POINTS)]).toHaveLength(2);
    await page.emulateMedia({ media: 'screen' });
    return picture;
  });

  await page.goto(EXAMPLE);
  const markers = seen(anna).getByRole('rowheader');
  const nodeOf = async (): Promise<string | undefined> =>
    (await robot.call('sessionRuntimeGetList')).elements[0]?.processingModules[0]?.nodeId;

  await test.step('in a worker of this tab: first the clip, in metres', async () => {
    await start(anna).click();
    await expect(markers).toHaveText(['aruco_4x4_50:7', 'aruco_4x4_50:12', 'aruco_4x4_50:23']);
    const distance = seen(anna).getByRole('row', { name: /:12/ }).getByRole('cell').last();
    expect(Number(await distance.textContent())).toBeCloseTo(Math.hypot(0.02, 0.05, 0.3), 2);
    await expect(page.locator('[data-outline]')).toHaveCount(3);
  });

  await test.step('then the sheet as an image file', async () => {
    await page.getByRole('radio', { name: 'File' }).click();
    await page
      .locator('input[type=file]')
      .setInputFiles({ name: 'sheet.png', mimeType: 'image/png', buffer: sheet });
    await expect(seen(anna)).toContainText('No marker of this dictionary');
    await page.getByRole('combobox', { name: 'Dictionary' }).click();
    await page.getByRole('option', { name: /36h11/ }).click();
    const printed = [40, 41, 42, 43].map((id) => `apriltag_36h11:${id}`);
    await expect(markers).toHaveText(printed);

    await page
      .getByRole('radiogroup', { name: 'Node that runs the modules' })
      .getByRole('radio', { name: /^Master/ })
      .click();
    const { id: masterId } = await robot.call('serverConfiguration');
    await expect.poll(nodeOf).toBe(masterId);
    await expect(markers).toHaveText(printed);
    await page.getByRole('button', { name: 'Stop', exact: true }).click();
    await expect.poll(nodeOf).toBeUndefined();
  });
});

test('a print that is not possible says why, and a phone can print too', async ({ room }) => {
  const { page } = await room.withPhone('Ben');
  await page.goto(PRINT);
  const button = page.getByRole('button', { name: 'Print', exact: true });
  await page.getByLabel('Last id').fill('50');
  await expect(page.getByRole('alert')).toContainText('0 to 49');
  await page.getByLabel('Last id').fill('3');
  await page.getByRole('radio', { name: 'Calibration board' }).click();
  await expect(page.getByRole('img', { name: /5 by 7 squares/ })).toBeVisible();
  await page.evaluate(() => {
    window.print = () => void (document.body.dataset['printed'] = 'yes');
  });
  await button.click();
  await expect(page.locator('body')).toHaveAttribute('data-printed', 'yes');
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(412);
});
