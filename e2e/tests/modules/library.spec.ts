import { readFile } from 'node:fs/promises';
import { expect, test } from '../../fixtures/test.ts';
import { ModulesPage } from '../../pages/modules-page.ts';
import { SessionPage } from '../../pages/session-page.ts';
import { SessionsPage } from '../../pages/sessions-page.ts';
import { Shell } from '../../pages/shell.ts';

const DOUBLE = JSON.stringify({
  name: 'doubler',
  authors: ['Anna'],
  tags: ['arithmetic'],
  inputs: [{ internalName: 'number', messageFormat: 'double' }],
  outputs: [{ internalName: 'twice', messageFormat: 'double' }],
  language: 'JS',
  onProcessingStringified:
    '(deltaTimeMs, inputs) => ({\n  outputs: { twice: { double: 2 * inputs.number.double } },\n})',
});

test('a library of modules is searched, and takes and gives modules @smoke', async ({ room }) => {
  const anna = await room.atDesk('Anna');
  const modules = new ModulesPage(anna);
  await test.step('the library is searched by words and data formats, and a module tells all about itself', async () => {
    await modules.open();
    await modules.search.fill('mirror');
    await expect(modules.list.getByRole('listitem')).toHaveCount(1);
    await modules.link('mirror-pointer').click();
    await expect(modules.detail).toContainText('built in');
    await expect(modules.detail.getByRole('region', { name: 'Inputs' })).toContainText('pointer');
    await expect(modules.detail).toContainText('True swaps left and right.');
    await expect(modules.detail.getByRole('region', { name: 'Compatible nodes' })).toContainText(
      'Master',
    );
    await expect(
      modules.detail.getByRole('region', { name: 'Source of onProcessing' }),
    ).toContainText('mirrorX');
    await modules.search.fill('');
    await anna.page.getByRole('combobox', { name: 'Data format' }).click();
    await anna.page.getByRole('option', { name: 'quaternion' }).click();
    await expect(modules.link('low-pass-quaternion')).toBeVisible();
    await expect(modules.link('mirror-pointer')).toHaveCount(0);
  });

  await test.step('a module is imported, used, duplicated, exported, deleted and brought back', async () => {
    await modules.open();
    await expect(modules.link('clock')).toBeVisible();
    await modules.importFile('doubler.pm', DOUBLE);
    await expect(modules.detail).toContainText('stored');
    await expect(modules.detail).toContainText('arithmetic');

    const [download] = await Promise.all([
      anna.page.waitForEvent('download'),
      modules.choose('doubler', 'Export'),
    ]);
    expect(JSON.parse(await readFile(await download.path(), 'utf8'))).toMatchObject({
      name: 'doubler',
      outputs: [{ internalName: 'twice' }],
    });

    await modules.choose('doubler', 'Duplicate');
    await expect(modules.detail.getByRole('heading', { level: 2 }).first()).toHaveText(
      'doubler copy',
    );
    await modules.choose('doubler copy', 'Delete');
    await expect(modules.link('doubler copy')).toHaveCount(0);
    await anna.page.getByRole('button', { name: 'Undo' }).click();
    await expect(modules.link('doubler copy')).toBeVisible();

    await test.step('a session uses it by its name alone [SE-1], and the library says so', async () => {
      const session = new SessionPage(anna);
      await anna.page.goto('/sessions/new/text');
      const text = { name: 'Doubles', processingModules: [{ name: 'doubler' }] };
      await session.write(JSON.stringify(text), 'Create');
      await expect(session.graph.node('Module doubler')).toContainText('twice');
      await anna.page.goto('/modules/doubler');
      const users = modules.detail.getByRole('region', { name: 'Sessions that use this module' });
      await expect(users).toContainText('Doubles');
    });

    await test.step('what came with the program cannot be deleted [SE-22]', async () => {
      await anna.page.goto('/modules/clock');
      await anna.page.getByRole('button', { name: 'More for clock', exact: true }).click();
      await expect(anna.page.getByRole('menuitem', { name: 'Export' })).toBeVisible();
      await expect(anna.page.getByRole('menuitem', { name: 'Delete' })).toHaveCount(0);
      await anna.page.keyboard.press('Escape');
    });

    await test.step('a file that is none says why', async () => {
      await modules.importFile('broken.pm', '{ "name": ');
      await expect(anna.page.getByRole('alert')).toContainText('broken.pm, line 1');
    });
  });
});

test('a tab that was let run modules still does after a reload [PM-60]', async ({ room }) => {
  const ben = await room.withPhone('Ben');
  const modules = new ModulesPage(ben);
  await modules.open();
  await modules.tabSwitch.click();
  await expect(ben.page.getByRole('status').filter({ hasText: 'Ready' })).toBeVisible();
  await ben.page.reload();
  await expect(modules.tabSwitch).toBeChecked();
  await expect(ben.page.getByRole('status').filter({ hasText: 'Ready' })).toBeVisible();

  const anna = await room.atDesk('Anna');
  const session = new SessionPage(anna);
  await new SessionsPage(anna).open();
  await new SessionsPage(anna).startExample('Smoothing chain');
  await session.place('clock', /^Ben/);
  await session.show('Statistics');
  await expect(session.fact('clock', 'Runs/s')).toHaveText(/^[1-9]/);
  await new Shell(ben.page).go('Home');
  await new Shell(ben.page).expectModulesHere(1);
});
