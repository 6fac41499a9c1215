import { expect, test, type Room } from '../../fixtures/test.ts';
import { Fingers } from '../../pages/touch.ts';
import { StudiesPage } from '../../pages/studies-page.ts';

/** A phone that publishes touches, until the test ends. */
async function tapOnPhone(room: Room): Promise<void> {
  const { page } = await room.withPhone('Mara');
  await page.goto('/devices/smart-device');
  const pad = page.getByRole('application').first();
  await pad.waitFor();
  await (await Fingers.on(page)).tapOn(pad);
}

test('the example study is run with a phone, led from two devices, and its participant deleted', async ({
  room,
}) => {
  const anna = new StudiesPage(await room.atDesk('Anna'));
  await anna.open();
  await anna.button('Use the example').click();
  await expect(anna.page.getByLabel('Name', { exact: true }).first()).toHaveValue('Tap study');
  await expect(anna.page.getByRole('table', { name: 'Preview of the orders' })).toContainText(
    'Participant 2',
  );

  await test.step('the run begins with the next code, and the check list asks for a phone', async () => {
    await anna.openPart('Run');
    await expect(anna.page.getByLabel('Participant code')).toHaveValue('P01');
    await expect(anna.checks).toContainText('Missing');
    await anna.button('Start run').click();
    await anna.button('Show the consent text').click();
    const consent = anna.page.getByRole('dialog', { name: 'Consent' });
    await consent.getByRole('checkbox').check();
    await consent.getByRole('button', { name: 'I agree' }).click();
    await anna.button('Start').click();
    await expect(anna.page.getByRole('dialog')).toContainText('Phone, missing');
    await anna.button('Cancel').click();
    await tapOnPhone(room);
    await expect(anna.checks).toContainText('Ready');
  });

  const ben = new StudiesPage(await room.withPhone('Ben'));
  await test.step('a second phone follows, and leads the first block', async () => {
    await ben.page.goto(new URL(anna.page.url()).pathname.replace('/run', ''));
    await ben.button('Start').tap();
    await expect(anna.button('Stop')).toBeVisible();
    await anna.page.keyboard.press('m');
    await expect(anna.page.getByText('Moment marked')).toBeVisible();
    await ben.button('Error').tap();
    await ben.button('Stop').tap();
    await expect(anna.blocks.first()).toContainText('Done');
    await expect(anna.blocks.first()).toContainText('sub-P01_ses-1_task-LeftHand_run-01');
  });

  await test.step('the second block is recorded, and the end names both files', async () => {
    await anna.page.getByLabel('New note').fill('Tired');
    await anna.button('Add note').click();
    await anna.button('Start').click();
    await expect(ben.button('Stop')).toBeVisible();
    await anna.button('Stop').click();
    await anna.button('End run').click();
    const files = anna.page.getByRole('list', { name: 'Recordings of the run' });
    await expect(files.getByRole('listitem')).toHaveCount(2);
    await expect(ben.page.getByRole('heading', { name: /P01 is done/ })).toBeVisible();
    await files
      .getByRole('link', { name: /LeftHand/ })
      .first()
      .click();
    await expect(anna.page.getByRole('article', { name: /Recording sub-P01/ })).toBeVisible();
    await anna.page.goBack();
  });

  await test.step('everything of the participant is deleted, and reported', async () => {
    await anna.openPart('Participants');
    await expect(anna.participants).toHaveCount(1);
    await anna.button('Delete P01').click();
    const dialog = anna.page.getByRole('dialog');
    await expect(dialog).toContainText('1 run with consent, 1 note and 2 recordings');
    await dialog.getByRole('button', { name: 'Delete P01' }).click();
    await expect(anna.page.getByText(/^Deleted P01: 1 run, 1 note, 2 recordings/)).toBeVisible();
    await expect(anna.participants).toHaveCount(0);
    await anna.page.goto('/recordings');
    await expect(anna.page.getByText('Recordings appear here.')).toBeVisible();
  });
});
