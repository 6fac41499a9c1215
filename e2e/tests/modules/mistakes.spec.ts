import type { Locator } from '@playwright/test';
import { expect, test } from '../../fixtures/test.ts';
import { ModuleEditor } from '../../pages/module-editor.ts';
import { SessionPage } from '../../pages/session-page.ts';
import { SessionsPage } from '../../pages/sessions-page.ts';

const NEARBY = {
  name: 'Nearby',
  processingModules: [
    {
      name: 'measure',
      language: 'JS',
      processingMode: { frequency: { hertz: 20 } },
      outputs: [{ internalName: 'distance', messageFormat: 'double' }],
      onProcessingStringified: '() => ({ outputs: { distance: 3 * Math.random() } })',
    },
  ],
  ioMappings: [
    {
      processingModuleName: 'measure',
      outputMappings: [{ outputName: 'distance', topic: '/nearby/distance' }],
    },
  ],
};
const SENTENCE = 'Output "distance": write { double: value }, not a bare number.';

test('a mistake in an output is told in the words of the author, once, in all places [PM-33]', async ({
  room,
}) => {
  const anna = await room.atDesk('Anna');
  const session = new SessionPage(anna);
  await anna.page.goto('/sessions/new/text');
  await session.write(JSON.stringify(NEARBY, undefined, 2), 'Create');
  await expect(session.graph.title).toHaveText('Nearby');
  await session.act('Start');
  await session.show('Log');

  await test.step('in the problems and the log of the session, with its number', async () => {
    await expect(session.problems).toContainText(SENTENCE);
    await expect(session.problems).toContainText(/× [2-9]\d/);
    await expect(session.problems.getByRole('listitem')).toHaveCount(1);
    // A machine with much to do skips runs, which is another event.
    const event = session.events.getByRole('listitem').filter({ hasText: SENTENCE });
    await expect(event).toHaveCount(1);
    await expect(event).toContainText(/× [2-9]\d/);
  });

  await test.step('in the list of sessions, among those with problems, and on Home', async () => {
    const sessions = new SessionsPage(anna);
    await sessions.open();
    await anna.page.getByRole('radio', { name: 'Problems' }).click();
    await expect(sessions.row('Nearby')).toContainText(SENTENCE);
    await anna.page.goto('/');
    await expect(anna.page.getByRole('heading', { level: 1 })).toContainText(/needs attention\./);
    await anna.page.goBack();
    await sessions.link('Nearby').click();
  });

  await test.step('on the node in the graph', async () => {
    const node = anna.page.getByRole('group', { name: /measure/ }).first();
    await expect(node).toContainText('Output "distance"');
  });

  await test.step('in the try-out of the editor', async () => {
    const editor = new ModuleEditor(anna);
    await editor.create('Blank');
    await editor.typeAfter('return { outputs', '');
    await anna.page.keyboard.press('Home');
    await anna.page.keyboard.insertText('return { outputs: { reslt: 3, result: 3 } };');
    await editor.step();
    await editor.step();
    const cause = editor.tryIt.getByRole('status').filter({ hasText: 'The code has an error' });
    await expect(cause).toContainText('× 2');
    await expect(editor.problems).toContainText('Write { double: value }, not a bare number.');
    await cause.getByRole('button', { name: 'Line 5' }).click();
    await expect(editor.code.getByRole('textbox')).toBeFocused();
    const underline = editor.code.locator('.squiggly-error').first();
    const lineY = async (line: Locator) => Math.round((await line.boundingBox())?.y ?? 0);
    const wrongLine = editor.lines.filter({ hasText: 'reslt' });
    await expect.poll(() => lineY(underline)).toBe(await lineY(wrongLine));
    await expect(editor.tryIt.getByRole('region', { name: 'Log' })).toContainText(
      'Output "reslt" is not declared. Did you mean "result"?',
    );

    await editor.tryIt.getByRole('button', { name: 'Run', exact: true }).press('Enter');
    await expect(editor.tryIt.getByRole('button', { name: 'Pause' })).toBeFocused();
    await editor.input('value').getByRole('textbox', { name: 'value' }).fill('21');
    await expect(cause).toBeVisible();
    await editor.typeAfter('reslt: 3', ' +');
    const wrong = editor.tryIt.getByRole('alert').filter({ hasText: 'The code has' });
    await expect(wrong).toBeVisible();
    await expect(editor.problems).not.toContainText('SyntaxError');
    await expect(cause).toBeHidden();
    await anna.page.keyboard.press('Control+a');
    await anna.page.keyboard.insertText(
      'onProcessing = () => ({ outputs: { result: { double: 7 } } });',
    );
    await expect(editor.output('result')).toContainText('7');
    await expect(cause).toBeHidden();
    await expect(wrong).toBeHidden();
  });
});
