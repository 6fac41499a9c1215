import { readFile } from 'node:fs/promises';
import type { UbiiClient } from '@ubii/client-web';
import { expect, test, type Room } from '../../fixtures/test.ts';
import { PanelsPage } from '../../pages/panels-page.ts';

async function robotWithTopics(room: Room): Promise<UbiiClient> {
  const robot = await room.program('Robot');
  robot.publish('/lab/angle', 'double', 0.25);
  robot.publish('/lab/state', 'string', '{"mode":"idle"}');
  return robot;
}

test('panels are made, arranged, and there again after a reload and in another browser @smoke @firefox', async ({
  room,
}) => {
  const robot = await robotWithTopics(room);
  const anna = new PanelsPage(await room.atDesk());
  await anna.open();
  await anna.add('/lab/angle');
  await anna.add('/lab/state');
  await expect(anna.panels).toHaveCount(2);
  await expect(anna.panel('/lab/state')).toContainText('"idle"');

  await anna.choose('/lab/angle', 'Value');
  await expect(anna.panel('/lab/angle')).toContainText('0.250');
  robot.publish('/lab/angle', 'double', 0.75);
  await expect(anna.panel('/lab/angle')).toContainText('0.750');

  await anna.addControl('Slider', '/lab/light');
  await anna.slider('/lab/light').press('End');
  let light = 0;
  robot.subscribe('/lab/light', { format: 'double' }).onRecord(({ value }) => (light = value));
  await expect.poll(() => light).toBe(1);
  // Anna owns the topic: its newest record says whether the value outlives her page.
  robot.publish('/lab/light', 'double', 0.5, { keepSeconds: 60 });
  await expect(anna.slider('/lab/light')).toHaveAttribute('aria-valuenow', '0.5');
  await anna.choose('/lab/light', 'Split below');
  await anna.panel('').getByRole('combobox', { name: 'Search topics' }).fill('/lab/light');
  await anna.panel('').getByRole('option', { name: '/lab/light' }).click();
  const plot = anna.panel('/lab/light, 2').getByRole('group', { name: /^Plot of/ });
  await expect(plot).toBeVisible();

  // In the moment in which the change before it comes into the address.
  const divider = anna.page.getByRole('separator', { name: 'Width of the panels' }).first();
  await divider.press('ArrowRight');
  await expect(divider).toHaveAttribute('aria-valuenow', '52');

  await anna.page.reload();
  await expect(anna.panels).toHaveCount(4);
  await expect(divider).toHaveAttribute('aria-valuenow', '52');
  await expect(anna.panel('/lab/angle')).toContainText('0.750');
  await expect(anna.slider('/lab/light')).toHaveAttribute('aria-valuenow', '0.5');
  await expect(plot).toBeVisible();

  await expect(anna.page).toHaveURL(/#layout=/);
  const { pathname, hash } = new URL(anna.page.url());
  const ben = new PanelsPage(await room.atDesk());
  await ben.page.goto(pathname + hash);
  await expect(ben.panels).toHaveCount(4);
  await expect(ben.panel('/lab/angle')).toContainText('0.75');
  await expect(ben.panel('/lab/state')).toContainText('"idle"');
  await ben.slider('/lab/light').press('ArrowRight');
  await expect(anna.slider('/lab/light')).toHaveAttribute('aria-valuenow', '0.51');
});

test('panels are arranged, and their layouts kept', async ({ room }) => {
  const robot = await robotWithTopics(room);
  const anna = new PanelsPage(await room.atDesk());
  await anna.open();
  await anna.add('/lab/angle');

  await test.step('a layout is saved by name, and goes away and comes back as a file; a damaged one changes nothing', async () => {
    await anna.chooseLayout('Save in this browser');
    await anna.page.getByRole('textbox', { name: 'Name' }).fill('Arm');
    await anna.page.getByRole('button', { name: 'Save', exact: true }).click();

    const download = anna.page.waitForEvent('download');
    await anna.chooseLayout('Export as a file');
    const file = await download;
    expect(file.suggestedFilename()).toBe('Arm.layout.json');
    const text = await readFile(await file.path(), 'utf8');
    expect(JSON.parse(text)).toMatchObject({ type: 'ubi-interact-layout', name: 'Arm' });

    await anna.chooseLayout('New layout');
    await expect(anna.page.getByText(/^No panels yet/)).toBeVisible();
    await anna.file.setInputFiles({
      name: 'Arm.layout.json',
      mimeType: 'application/json',
      buffer: Buffer.from(text),
    });
    await expect(anna.panel('/lab/angle')).toBeVisible();

    await anna.file.setInputFiles({
      name: 'Arm.layout.json',
      mimeType: 'application/json',
      buffer: Buffer.from(text.slice(0, -20)),
    });
    await expect(anna.page.getByRole('alert')).toContainText('not JSON');
    await expect(anna.page.getByRole('alert')).toContainText('Nothing was changed.');
    await expect(anna.panel('/lab/angle')).toBeVisible();

    await anna.chooseLayout('New layout');
    await expect(anna.panels).toHaveCount(0);
    await anna.chooseLayout('Arm');
    await expect(anna.panel('/lab/angle')).toBeVisible();
  });

  await test.step('a panel is moved, shown alone, removed, and what was done is undone', async () => {
    await anna.add('/lab/state');
    const [angle, state] = [anna.panel('/lab/angle'), anna.panel('/lab/state')];
    const leftOf = async (panel: typeof angle): Promise<number> => (await panel.boundingBox())!.x;
    expect(await leftOf(angle)).toBeLessThan(await leftOf(state));
    await anna.choose('/lab/angle', 'Move right');
    await expect.poll(async () => (await leftOf(angle)) > (await leftOf(state))).toBe(true);

    await angle.getByRole('button', { name: 'Maximise' }).click();
    await expect(state).toBeHidden();
    await angle.getByRole('button', { name: 'Show all panels' }).click();
    await expect(state).toBeVisible();

    await anna.choose('/lab/state', 'Remove panel');
    await expect(anna.panels).toHaveCount(1);
    await anna.page.getByRole('button', { name: 'Undo' }).click();
    await expect(anna.panels).toHaveCount(2);
  });

  await test.step('plots share their time and the reading line, and take series that are dragged onto them', async () => {
    robot.publish('/lab/speed', 'double', 3);
    await anna.choose('/lab/state', 'Remove panel');
    await anna.add('/lab/speed');
    const [angle, speed] = [anna.panel('/lab/angle'), anna.panel('/lab/speed')];
    await angle.getByRole('button', { name: 'Pause this panel' }).click();
    await expect(speed.getByRole('button', { name: 'Resume' })).toBeVisible();
    await speed.getByRole('group', { name: /^Plot of/ }).press('ArrowLeft');
    await expect(angle.getByTestId('reading')).toBeVisible();
    await speed.getByRole('button', { name: 'Resume' }).click();

    const lines = angle.getByRole('list', { name: 'Lines' }).getByRole('listitem');
    await expect(lines).toHaveCount(1);
    await speed.getByRole('heading').locator('[draggable]').dragTo(angle);
    await expect(lines).toHaveCount(2);
    await anna.page.getByRole('button', { name: 'Undo' }).click();
    await expect(lines).toHaveCount(1);
    await anna.page.getByRole('button', { name: 'Add panel' }).click();
    await anna.page
      .getByRole('option', { name: '/lab/speed' })
      .dragTo(angle, { targetPosition: { x: 60, y: 120 } });
    await expect(lines).toHaveCount(2);
    await anna.page.keyboard.press('Escape');
    await anna.choose('/lab/speed', 'Remove panel');
  });

  await test.step('a layout is saved with a session, and opened by its address', async () => {
    const session = await robot.call('sessionRuntimeAdd', { name: 'Arm of the lab' });
    await anna.chooseLayout('Save with a session');
    await anna.page.getByRole('option', { name: 'Arm of the lab' }).click();
    await expect(anna.page.getByText('Saved with the session "Arm of the lab"')).toBeVisible();
    const cara = new PanelsPage(await room.atDesk());
    await cara.page.goto(`/panels?session=${session.id}`);
    await expect(cara.panels).toHaveCount(1);
    await expect(cara.page).toHaveURL(/#layout=/);
    await cara.page.keyboard.press('f');
    await expect(cara.page.getByRole('button', { name: 'Exit full screen' })).toBeVisible();
    await expect(cara.panel('/lab/angle')).toBeInViewport();
  });

  await test.step('on a phone panels stand one above the other', async () => {
    const ben = new PanelsPage(await room.withPhone());
    await ben.page.goto('/panels?topic=/lab/angle');
    await expect(ben.panel('/lab/angle')).toBeVisible();
    await ben.add('/lab/state');
    const above = (await ben.panel('/lab/angle').boundingBox())!;
    const below = (await ben.panel('/lab/state').boundingBox())!;
    expect(below.x).toBe(above.x);
    expect(below.y).toBeGreaterThanOrEqual(above.y + above.height - 1);
  });
});
