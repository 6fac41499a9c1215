import { readFile } from 'node:fs/promises';
import { expect, test } from '../../fixtures/test.ts';
import { SessionPage } from '../../pages/session-page.ts';
import { SessionsPage } from '../../pages/sessions-page.ts';
import { Shell } from '../../pages/shell.ts';

const BROKEN = `{
  "name": "Mirror",
  "processingModules": [
    { "name": "mirror-pointer" },
    { "name": "no-such-module" }
  ],
  "ioMappings": [
    {
      "processingModuleName": "mirror-pointer",
      "inputMappings": [
        { "inputName": "pointr", "topic": "/a" }
      ]
    }
  ]
}
`;
const WHOLE = BROKEN.replace(',\n    { "name": "no-such-module" }', '').replace(
  'pointr',
  'pointer',
);

test('sessions are written as JSON, changed by several people, and travel as files', async ({
  room,
}) => {
  const anna = await room.atDesk('Anna');
  const { page } = anna;
  const session = new SessionPage(anna);
  const sessions = new SessionsPage(anna);
  await test.step('a session is written as JSON; all that is wrong stands beside its line [SE-3]', async () => {
    await page.goto('/sessions');
    await sessions.newSession.click();
    await session.show('JSON');

    await test.step('no JSON', async () => {
      await session.text.fill('{\n  "name": "x"\n  "tags": []\n}');
      await expect(session.textProblems).toContainText('Expected a comma or }');
      await expect(page.getByRole('button', { name: 'Show line 3' })).toBeVisible();
    });
    await test.step('what the master finds', async () => {
      await session.write(BROKEN, 'Create');
      await expect(session.textProblems).toContainText('"no-such-module"');
      await expect(session.textProblems).toContainText('no input named "pointr"');
      await page.getByRole('button', { name: 'Show line 11' }).first().click();
      await expect(session.text).toBeFocused();
    });
    await test.step('put right', async () => {
      await session.write(WHOLE, 'Create');
      await expect(session.graph.title).toHaveText('Mirror');
      await session.act('Start');
      await session.expectState('Running');
      await session.show('Log');
      await expect(session.problems).toContainText('Topic "/a" has no value');
    });
  });

  await test.step('a running session is edited as JSON; what others changed meanwhile is not overwritten [SE-15]', async () => {
    const ben = await room.atDesk('Ben');
    const theirs = new SessionPage(ben);
    await session.show('JSON');
    await ben.page.goto(new URL(anna.page.url()).pathname);
    const text = await session.text.inputValue();
    await session.write(text.replace('"/a"', '"/b"'), 'Apply');
    await expect(session.graph.node('Topic /b')).toBeVisible();
    await session.expectState('Running');

    await test.step('who has not begun gets the new text, who has is told', async () => {
      await expect(theirs.text).toHaveValue(/"\/b"/);
      await theirs.text.fill((await theirs.text.inputValue()).replace('"/b"', '"/c"'));
      await session.write((await session.text.inputValue()).replace('"/b"', '"/d"'), 'Apply');
      await expect(ben.page.getByRole('alert')).toContainText('The session has changed');
      const apply = ben.page.getByRole('button', { name: 'Apply', exact: true });
      await expect(apply).toHaveAttribute('aria-disabled', 'true');
      await ben.page.getByRole('button', { name: 'Load the current version' }).click();
      await expect(theirs.text).toHaveValue(/"\/d"/);
    });
  });

  await test.step('a session travels as one file, with the source of its modules', async () => {
    const [download] = await Promise.all([
      anna.page.waitForEvent('download'),
      session.choose('Export'),
    ]);
    expect(download.suggestedFilename()).toBe('Mirror.session');
    const text = await readFile(await download.path(), 'utf8');
    expect(JSON.parse(text)).toMatchObject({
      name: 'Mirror',
      processingModules: [{ name: 'mirror-pointer', onProcessingStringified: expect.any(String) }],
    });

    await new Shell(anna.page).go('Sessions');
    await sessions.importFiles([{ name: 'Mirror.session', text }]);
    await expect(session.graph.title).toHaveText('Mirror 2');

    await test.step('a file is dropped on the page', async () => {
      await new Shell(anna.page).go('Sessions');
      await expect(sessions.row('Mirror 2')).toBeVisible();
      await sessions.dropFile('Mirror.session', text);
      await expect(session.graph.title).toHaveText('Mirror 3');
    });

    await test.step('a file that is broken opens with what is wrong with it', async () => {
      await new Shell(anna.page).go('Sessions');
      await sessions.importFiles([{ name: 'broken.session', text: BROKEN }]);
      const dialog = anna.page.getByRole('dialog', { name: 'Import a session' });
      await expect(dialog).toContainText('The module no-such-module is unknown');
      await dialog.getByRole('button', { name: 'New session' }).click();
      await expect(anna.page).toHaveURL(/\/sessions\/[^/]+\/text$/);
      await expect(session.textProblems).toContainText('pointr');
    });
  });
});
