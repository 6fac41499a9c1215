import { readFile } from 'node:fs/promises';
import type { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';
import { Shell } from '../../pages/shell.ts';

/** A session that is kept on the disk. */
async function aSession(master: MasterProcess, name: string): Promise<string> {
  const { sessionList } = await callService(master.endpoints, {
    topic: SERVICES.sessionDatabaseSave.topic,
    session: { name, processingModules: [{ name: 'threshold' }] },
  });
  return sessionList!.elements[0]!.id;
}

const FOREIGN = JSON.stringify({
  name: 'Dance',
  processingModules: [{ name: 'low-pass' }, { name: 'gaze-at-home' }],
  ioMappings: [
    {
      processingModuleName: 'gaze-at-home',
      inputMappings: [{ inputName: 'image', topic: '/cam/image' }],
    },
  ],
});

test('a session is imported into, renamed, copied, deleted, and outlives its master', async ({
  room,
  master,
}) => {
  const desk = await room.atDesk('Anna');
  const anna = new GraphPage(desk);
  await test.step('files that are none are named with the place, and nothing is lost', async () => {
    await anna.open(await aSession(master, 'Chain'));
    const flow = JSON.stringify([{ id: 'a', type: 'inject', z: 'b', wires: [[]] }]);
    const cases = [
      ['broken.session', '{\n"processingModules": [\n{,}]}', 0, 'broken.session, line 3:'],
      ['flows.json', flow, 0, 'flows.json is a Node-RED flow, not a session.'],
      ['huge.session', '', 50 * 1024 * 1024, 'huge.session has 50 MB.'],
      ['large.session', '{"processingModules":[', 2_000_000, 'large.session, line 1'],
    ] as const;
    for (const [name, text, spaces, words] of cases) {
      await anna.dropFile(name, text, spaces);
      await expect(anna.importDialog).toContainText(words);
      await anna.importDialog.getByRole('button', { name: 'Close' }).last().click();
      await expect(anna.importDialog).toBeHidden();
    }
    await expect(anna.node('Module threshold')).toBeVisible();
  });

  await test.step('a file with modules nobody has comes in whole, says what is missing, and goes out again', async () => {
    await anna.dropFile('dance.session', FOREIGN);
    await expect(anna.importDialog).toContainText('The module gaze-at-home is unknown');
    await anna.importDialog.getByRole('button', { name: 'Add to this graph' }).click();
    await expect(anna.node('Module gaze-at-home')).toBeVisible();
    await expect(anna.node('Topic /cam/image')).toBeVisible();
    await expect(anna.socket('Module gaze-at-home', 'Input image')).toHaveAccessibleName(
      /1 connected/,
    );
    await expect(anna.page.getByText('gaze-at-home is unknown')).toBeVisible();

    await test.step('it is saved and exported with all it has', async () => {
      await anna.page.keyboard.press('Control+s');
      await expect(anna.life.getByRole('button', { name: /^Save(?! and)/ })).toBeHidden();
      const [download] = await Promise.all([
        anna.page.waitForEvent('download'),
        anna.choose('Export'),
      ]);
      const text = await readFile(await download.path(), 'utf8');
      expect(text).toContain('gaze-at-home');
      expect(JSON.parse(text)).toMatchObject({
        processingModules: [
          { name: 'threshold', onProcessingStringified: expect.any(String) },
          { name: 'low-pass', onProcessingStringified: expect.any(String) },
        ],
      });
    });

    await test.step('one step takes it back', async () => {
      await anna.canvas.focus();
      await anna.page.keyboard.press('Control+z');
      await expect(anna.node('Module gaze-at-home')).toBeHidden();
      await expect(anna.node('Module low-pass')).toBeHidden();
      await expect(anna.node('Module threshold')).toBeVisible();
      await anna.page.keyboard.press('Control+s');
      await expect(anna.life.getByRole('button', { name: /^Save(?! and)/ })).toBeHidden();
    });
  });

  await test.step('a session is renamed, copied, saved as another one, opened, deleted and brought back', async () => {
    await test.step('a new name counts at once, and can be undone', async () => {
      await anna.rename('First');
      await expect(anna.title).toHaveText('First');
      await expect(anna.life).not.toContainText('Save');
      await new Shell(anna.page).go('Sessions');
      await expect(anna.page.getByRole('link', { name: 'First', exact: true })).toBeVisible();
      await anna.page.goBack();
      await anna.rename('Second');
      await anna.canvas.focus();
      await anna.page.keyboard.press('Control+z');
      await expect(anna.title).toHaveText('First');
      await anna.page.keyboard.press('Control+s');
      await expect(anna.life).not.toContainText('Save');
    });

    await test.step('a click elsewhere saves the name, and works there', async () => {
      await anna.title.click();
      await anna.page.getByRole('textbox', { name: 'Name of the session' }).fill('Third');
      const filter = anna.palette.getByRole('searchbox');
      await filter.click();
      await expect(anna.title).toHaveText('Third');
      await expect(filter).toBeFocused();
      await anna.rename('First');
      await expect(anna.life).not.toContainText('Save');
    });

    await test.step('a copy takes along what is not saved', async () => {
      await anna.drag(anna.paletteModule('statistics'), await anna.spot(0.6, 0.2));
      await expect(anna.node('Module statistics')).toBeVisible();
      await anna.choose('Duplicate');
      await expect(anna.title).toHaveText('First copy');
      await expect(anna.node('Module statistics')).toBeVisible();
    });

    await test.step('saved as another one', async () => {
      await anna.page.keyboard.press('Control+Shift+s');
      const dialog = anna.page.getByRole('dialog', { name: 'Save as another session' });
      await dialog.getByRole('textbox', { name: 'Name' }).fill('Second');
      await dialog.getByRole('button', { name: 'Save' }).click();
      await expect(anna.title).toHaveText('Second');
    });

    await test.step('the first one is found, and its changes are still there', async () => {
      await anna.page.keyboard.press('Control+o');
      const dialog = anna.page.getByRole('dialog', { name: 'Open a session' });
      await dialog.getByRole('searchbox').fill('First');
      await expect(dialog.getByRole('button', { name: /^Second/ })).toBeHidden();
      await dialog.getByRole('button', { name: /^First threshold/ }).click();
      await expect(anna.title).toHaveText('First');
      await anna.page.getByRole('button', { name: 'Restore changes' }).click();
      await expect(anna.node('Module statistics')).toBeVisible();
    });

    await test.step('deleted, and brought back with the changes', async () => {
      await anna.choose('Delete');
      await expect(anna.page).toHaveURL(/\/sessions$/);
      await anna.page.getByRole('button', { name: 'Undo' }).click();
      await expect(anna.title).toHaveText('First');
      await anna.page.getByRole('button', { name: 'Restore changes' }).click();
      await expect(anna.node('Module statistics')).toBeVisible();
    });

    await test.step('what the menu has, the palette finds', async () => {
      await anna.page.keyboard.press('Control+k');
      await anna.page.getByRole('combobox').fill('new empty session');
      await anna.page.keyboard.press('Enter');
      await expect(anna.title).toHaveText('Session');
      await expect(anna.page.getByRole('region', { name: 'Getting started' })).toBeVisible();
    });
  });

  await test.step('the work goes on while the master is away, and is saved when it is back', async () => {
    const id = await aSession(master, 'Master away');
    await anna.open(id);
    await expect(anna.paletteModule('statistics')).toBeVisible();
    desk.watch.expect(/net::ERR_CONNECTION_(REFUSED|RESET)/, /WebSocket connection to .* failed/);
    await master.stop();
    await expect(anna.life).toContainText('Not connected');
    await anna.drag(anna.paletteModule('statistics'), await anna.spot(0.6, 0.2));
    await expect(anna.life).toContainText('kept in this browser');
    await anna.page.keyboard.press('Control+s');
    await expect(anna.life).toContainText('saved after the reconnect');
    await master.restart();
    await expect(anna.life).not.toContainText('Not connected');
    await expect(anna.node('Module statistics')).toBeVisible();
    await expect(anna.life.getByRole('button', { name: /^Save(?! and)/ })).toBeHidden();
    await anna.page.reload();
    await expect(anna.node('Module statistics')).toBeVisible();
  });
});
