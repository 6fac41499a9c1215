import { createSocket } from 'node:dgram';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expectAccessible } from '../../fixtures/accessible.ts';
import { expect, test } from '../../fixtures/test.ts';
import { BridgesPage } from '../../pages/bridges-page.ts';

/** Something that speaks OSC, and what it heard. */
async function openMixer() {
  const heard: string[] = [];
  const socket = createSocket('udp4');
  // An address ends with a zero.
  socket.on('message', (bytes) => heard.push(bytes.toString('latin1').split('\0')[0] ?? ''));
  await new Promise<void>((resolve) => socket.bind(0, '127.0.0.1', resolve));
  return { heard, target: `osc://127.0.0.1:${socket.address().port}`, close: () => socket.close() };
}

test('an admin edits what a bridge passes; the file follows, and may be edited as well [BR-82] [BR-83] [BR-5] @smoke', async ({
  room,
}, testInfo) => {
  const [anna, robot, mixer] = await Promise.all([
    room.atDesk('Anna'),
    room.program('Robot'),
    openMixer(),
  ]);
  robot.publish('/faders/left', 'double', 0.5);
  const bridges = new BridgesPage(anna);
  const { page } = anna;
  const file = testInfo.outputPath('bridge.json');
  const written = (): readonly object[] =>
    (JSON.parse(readFileSync(file, 'utf8')) as { mappings: object[] }).mappings;

  await bridges.open();
  await expect(page.getByText('npm run bridge -- mqtt://localhost:1883')).toBeVisible();
  await room.bridge('Stage', [mixer.target], join(file, '..'));
  await expect(bridges.bridge('Stage')).toContainText('The first change creates it.');
  await expect(bridges.bridge('Stage')).toContainText('Connected');

  await test.step('a wrong pattern is refused at its field, a right one is previewed', async () => {
    await bridges.bridge('Stage').getByRole('button', { name: 'Add a mapping' }).click();
    await bridges.form.getByRole('radio', { name: 'Out' }).click();
    await bridges.field('OSC address').click();
    await page.keyboard.type('/fader/{2}');
    await bridges.field('Topic').click();
    await page.keyboard.type('/faders/*');
    await expect(bridges.field('OSC address')).toHaveAttribute('aria-invalid', 'true');
    await expect(bridges.form).toContainText('Has the placeholder {2}');
    await expectAccessible(page);
    await bridges.field('OSC address').fill('/fader/{1}');
    await expect(bridges.preview).toContainText('/faders/left');
    await expect(bridges.preview).toContainText('/fader/left');
    await page.keyboard.press('Enter');
    await expect(bridges.form).toBeHidden();
  });
  const out = { direction: 'out', foreign: '/fader/{1}', topic: '/faders/*', format: 'double' };
  expect(written()).toEqual([out]);
  await expect.poll(() => mixer.heard).toContain('/fader/left');
  const name = '/fader/{1} out /faders/*';
  await expect(bridges.mappings).toContainText(/passed \d/);

  await test.step('a mapping is disabled, and Undo enables it', async () => {
    await bridges.choose(name, 'Disable');
    await expect(bridges.mappings).toContainText('Disabled');
    expect(written()).toEqual([{ ...out, enabled: false }]);
    await bridges.undo();
    await expect(bridges.mappings).not.toContainText('Disabled');
    expect(written()).toEqual([out]);
  });

  await test.step('what the file says meanwhile is not overwritten unasked', async () => {
    await bridges.mapping('/faders/*').click();
    await bridges.field('Topic').fill('/mine/*');
    const theirs = { ...out, maxRateHz: 5 };
    writeFileSync(file, JSON.stringify({ version: 1, mappings: [theirs] }));
    await bridges.form.getByRole('button', { name: 'Save' }).click();
    const conflict = bridges.form.getByRole('alert');
    await expect(conflict).toContainText('Another user changed this mapping');
    expect(written()).toEqual([theirs]);
    await conflict.getByRole('button', { name: 'Keep mine' }).click();
    await expect(bridges.form).toBeHidden();
    expect(written()).toMatchObject([{ topic: '/mine/*' }]);
  });

  await test.step('a mapping is removed by a key, and comes back', async () => {
    await bridges.mapping('/mine/*').focus();
    await page.keyboard.press('Delete');
    await expect(bridges.bridge('Stage')).toContainText('This bridge passes nothing yet.');
    await expect(page.getByRole('button', { name: 'Add a mapping' })).toBeFocused();
    await bridges.undo();
    await expect(bridges.mapping('/mine/*')).toBeVisible();
    await expectAccessible(page);
  });
  mixer.close();
});
