import { expect, test } from '../../fixtures/test.ts';
import { SessionPage } from '../../pages/session-page.ts';
import { SessionsPage } from '../../pages/sessions-page.ts';
import { Shell } from '../../pages/shell.ts';

const source = (lines: readonly string[]): string => lines.join('\n');
const NOISY = {
  name: 'Noisy',
  processingModules: [
    {
      name: 'counts',
      language: 'JS',
      processingMode: { frequency: { hertz: 10 } },
      onProcessingStringified: source([
        '(deltaTimeMs, inputs, state) => {',
        '  state.n = (state.n ?? 0) + 1;',
        "  console.log('run', state.n);",
        "  if (state.n % 3 === 0) throw new Error('every third run');",
        '}',
      ]),
    },
    {
      name: 'loops',
      language: 'JS',
      processingMode: { frequency: { hertz: 10 } },
      onProcessingStringified: '() => { for (;;) {} }',
    },
  ],
};

const CHAIN = {
  name: 'Chain',
  processingModules: [{ name: 'clock' }, { name: 'statistics' }],
  ioMappings: [
    {
      processingModuleName: 'clock',
      outputMappings: [{ outputName: 'sine', topic: '/chain/sine' }],
    },
    {
      processingModuleName: 'statistics',
      inputMappings: [{ inputName: 'value', topic: '/chain/sine' }],
    },
  ],
};

test('modules fail, are moved to tabs, and are taken back', async ({ room }) => {
  const anna = await room.atDesk('Anna');
  const session = new SessionPage(anna);
  await test.step('what goes wrong in a module is told with its line, and an endless loop stops nothing else [PM-13, PM-53]', async () => {
    await anna.page.goto('/sessions/new/text');
    await session.write(JSON.stringify(NOISY, undefined, 2), 'Create');
    await expect(session.graph.title).toHaveText('Noisy');
    await session.act('Start');
    await session.show('Log');

    await expect(session.events).toContainText('run 2');
    await expect(session.events).toContainText('every third run');
    await expect(session.events).toContainText('onProcessing:4');
    await expect(session.events).toContainText('killed');

    await test.step('the module that loops is given up, the other runs on', async () => {
      await session.expectState('Degraded');
      await expect(session.problems).toContainText('loops');
      await session.show('Statistics');
      await expect(session.module('loops')).toContainText('Failed');
      await expect(session.fact('counts', 'Runs/s')).toHaveText(/^[1-9]/);
      await expect(session.fact('counts', 'Errors')).toHaveText(/^[1-9]/);
    });

    await test.step('a click on the number of problems selects the next one', async () => {
      await session.graph.life.getByRole('button', { name: /^\d problems?$/ }).click();
      await expect(session.graph.inspector.getByRole('list', { name: 'Problems' })).toBeVisible();
      await session.show('Log');
    });

    await test.step('the log is filtered', async () => {
      await anna.page.getByRole('radio', { name: 'Problems' }).click();
      await expect(session.events).not.toContainText('run 2');
      await anna.page.getByRole('combobox', { name: 'Module', exact: true }).click();
      await anna.page.getByRole('option', { name: 'loops' }).click();
      await expect(session.events).not.toContainText('every third run');
    });

    await test.step('Home and the list say so', async () => {
      await new Shell(anna.page).go('Home');
      await expect(anna.page.getByRole('heading', { level: 1 })).toContainText(
        'It needs attention',
      );
      await expect(anna.page.getByRole('list', { name: 'Problems' })).toContainText('loops');
      await new Shell(anna.page).go('Sessions');
      await expect(new SessionsPage(anna).row('Noisy')).toContainText('Degraded');
    });
  });

  await test.step('a module is moved to somebody’s tab, and back when the tab is gone [SE-30, SE-31]', async () => {
    const ben = await room.atDesk('Ben');
    await ben.page.goto('/settings');
    await ben.page.getByRole('switch', { name: /^Run modules in this tab/ }).click();
    await expect(ben.page.getByRole('status').filter({ hasText: 'Ready' })).toBeVisible();

    await anna.page.goto('/sessions/new/text');
    await session.write(JSON.stringify(CHAIN, undefined, 2), 'Create');
    await expect(session.graph.title).toHaveText('Chain');
    await session.act('Start');
    await session.expectState('Running');
    await session.show('Statistics');
    await session.place('clock', /^Ben/);
    await expect(ben.page.getByRole('status').filter({ hasText: 'Runs 1 module' })).toBeVisible();
    await session.expectState('Running');
    await expect(session.fact('clock', 'Runs/s')).toHaveText(/^[1-9]/);

    await ben.page.getByRole('switch', { name: /^Run modules in this tab/ }).click();
    await session.expectState('Degraded');
    await session.show('Log');
    await expect(session.problems).toContainText('clock');
    await session.show('Statistics');
    await session.place('clock', /^Master/);
    await session.expectState('Running');
  });

  await test.step('“This tab” can be chosen at once: it is turned on by that', async () => {
    await session.place('statistics', /^This tab/);
    await new Shell(anna.page).expectModulesHere(1);
    await session.expectState('Running');
    await expect(session.fact('statistics', 'Runs/s')).toHaveText(/^[1-9]/);
  });
});
