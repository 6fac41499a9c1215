import { readFile } from 'node:fs/promises';
import type { Download } from '@playwright/test';
import { expect, test } from '../../fixtures/test.ts';

test.use({ masterStart: { flags: ['--limits', 'topicsPerClient=10', '--checks', 'throttle'] } });
const textOf = async (download: Download) => readFile(await download.path(), 'utf8');

test('limits are listed with their reason and use; what is near and what was met stands out [EX-35, EX-36]', async ({
  room,
}) => {
  const { page } = await room.atDesk('Anna');
  const robot = await room.program('Robot');
  await page.goto('/settings/limits');
  await expect(page.getByRole('table', { name: 'Messages' })).toContainText('3840 x 2160 RGBA');
  const loud = page.getByRole('table', { name: 'Reached or almost reached' });
  await expect(loud).toHaveCount(0);

  for (let i = 0; i < 9; i++) robot.publish(`/robot/${i}`, 'double', i);
  const row = loud.getByRole('row', { name: /Topics per client/ });
  await expect(row).toContainText('almost reached');
  await expect(row).toContainText('90 %');
  await expect(row.getByRole('link', { name: 'Robot' })).toBeVisible();

  for (let i = 0; i < 15; i++) robot.publish(`/robot/${i}`, 'double', i);
  await expect(row.getByText('reached', { exact: true })).toBeVisible();
  await expect(row).toContainText('100 %');
  await expect(row.getByRole('button', { name: 'Copy --limits topicsPerClient=20' })).toBeVisible();

  await page.getByRole('searchbox', { name: 'Search limits' }).fill('regular expression');
  await expect(page.getByRole('table', { name: 'Subscriptions' })).toBeVisible();
  await expect(loud).toHaveCount(0);
});

test('the master tells its log, its start options and its licences', async ({ room }) => {
  const { page } = await room.atDesk('Anna');

  await test.step('the log arrives line by line, is filtered, paused and downloaded [EX-37]', async () => {
    await page.goto('/settings/log');
    const log = page.getByRole('log', { name: 'Log of the master' });
    await expect(log).toContainText('Anna joined');
    const robot = await room.program('Robot');
    await expect(log).toContainText('Robot joined');
    await expect(page.getByText(/The last 1.000 are kept/)).toBeVisible();

    await page.getByRole('searchbox', { name: 'Search the log' }).fill('robot');
    await expect(log).not.toContainText('Anna joined');
    const downloading = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Download the shown lines' }).click();
    const text = await textOf(await downloading);
    expect(text).toMatch(/^\d{4}-\d\d-\d\dT.*Z INFO {2}Robot joined/m);
    expect(text).not.toContain('Anna');
    await page.getByRole('searchbox', { name: 'Search the log' }).fill('');

    await test.step('the level filter', async () => {
      await page.getByRole('combobox', { name: 'Level' }).click();
      await page.getByRole('option', { name: 'errors only' }).click();
      await expect(page.getByText('No matches for this search and level.')).toBeVisible();
      await page.getByRole('combobox', { name: 'Level' }).click();
      await page.getByRole('option', { name: 'everything' }).click();
    });

    await test.step('paused, it stands still; resumed, it has all of it', async () => {
      await page.getByRole('button', { name: /^Pause/ }).click();
      await robot.close();
      await expect(page.getByText(/^Paused\./)).toBeVisible();
      await room.program('Crane');
      await page.getByRole('button', { name: 'Resume' }).click();
      await expect(log).toContainText('Robot left');
      await expect(log).toContainText('Crane joined');
    });
  });

  await test.step('the master tells what it was started with, and a report of a fault has no secrets in it [EX-50]', async () => {
    await page.goto('/settings/master');
    const flags = page.getByRole('region', { name: 'Start options' });
    await expect(flags).toContainText('noisy publishers are throttled');
    const limits = flags.getByRole('listitem').filter({ hasText: '--limits' });
    await expect(limits).toContainText('topicsPerClient=10');
    await expect(limits).toContainText('set');
    await expect(flags.getByRole('listitem').filter({ hasText: /^--lan/ })).toContainText('off');

    const identity = await page.evaluate(() => sessionStorage.getItem('ubii.identity') ?? '');
    const downloading = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Save diagnostics' }).click();
    const text = await textOf(await downloading);
    const report = JSON.parse(text) as Record<string, { version?: string }>;
    expect(report['master']?.version).toMatch(/^\d+\.\d+\.\d+/);
    expect(report['page']?.version).toMatch(/^\d+\.\d+\.\d+/);
    expect(text).toContain('Anna joined');
    const { resumeToken } = JSON.parse(identity) as { resumeToken: string };
    expect(resumeToken).not.toBe('');
    expect(text).not.toContain(resumeToken);
  });

  await test.step('every package that is shipped is listed with its licence', async () => {
    await page.goto('/settings/licences');
    const list = page.getByRole('list', { name: 'Third-party packages' });
    for (const name of ['vue', 'fastify', '@fontsource-variable/inter', 'monaco-editor', 'ws']) {
      await expect(list.getByText(name, { exact: true })).toBeVisible();
    }
    await expect(list).not.toContainText('vitest');
    await page.getByRole('searchbox', { name: 'Search packages' }).fill('fastify master');
    await list.getByText('fastify', { exact: true }).click();
    await expect(list.getByLabel('Licence of fastify', { exact: true })).toContainText(
      'Permission is hereby granted',
    );
  });
});
