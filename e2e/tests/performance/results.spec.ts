import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { expect, test } from '../../fixtures/test.ts';
import { PerformancePage } from '../../pages/performance-page.ts';

const PLACES = [
  /^Message load/,
  /^Session speed/,
  /^Topic to screen/,
  /^Results/,
  /^Round trip/,
] as const;
const SHORT = { Rate: '30', 'Duration of each': '1' };

async function exported(page: Page, format: RegExp): Promise<{ path: string; text: string }> {
  await page.getByRole('button', { name: 'Export' }).click();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('menuitem', { name: format }).click(),
  ]);
  const path = await download.path();
  return { path, text: await readFile(path, 'utf8') };
}

test('results are kept over a reload, named, compared, exported and imported', async ({ room }) => {
  const anna = await room.atDesk('Anna');
  const page = new PerformancePage(anna);
  await page.open();
  await page.page.getByRole('radio', { name: 'Immediate' }).click();
  await page.fill(SHORT);
  await page.measure();
  await page.page.getByRole('button', { name: 'Rename the result' }).click();
  await page.page.getByRole('textbox', { name: 'Name of the result' }).fill('At home');
  await page.page.keyboard.press('Enter');
  await expect(page.page.getByRole('article', { name: 'At home' })).toBeVisible();
  await page.fill({ Rate: '60' });
  await page.measure();

  await page.open('results');
  await expect(page.kept).toHaveCount(2);
  await expect(page.kept.last()).toContainText('At home');

  await test.step('compared side by side', async () => {
    for (const box of await page.page.getByRole('checkbox').all()) await box.check();
    await page.page.getByRole('button', { name: 'Compare 2' }).click();
    const figures = page.page.getByRole('region', { name: 'Figures side by side' });
    await expect(figures.getByRole('columnheader')).toHaveText([
      'Figure',
      'At home',
      'Round trip: immediate, 60 Hz',
    ]);
    await expect(figures.getByRole('row', { name: /p95/ })).toContainText('%');
    const facts = page.page.getByRole('region', { name: 'Test conditions side by side' });
    await expect(facts.getByRole('row', { name: /Rate differs/ })).toContainText('30 Hz');
    await expect(page.chart('Immediate: round trips')).toContainText('At home');
    await page.page.reload();
    await expect(figures).toBeVisible();
  });

  const csv = await exported(page.page, /CSV/);
  expect(csv.text).toContain('At home,round-trip,');
  expect(csv.text).toContain('figure,immediate.p95,');
  const json = await exported(page.page, /JSON/);

  await test.step('imported in another browser', async () => {
    const ben = await room.atDesk('Ben');
    const there = new PerformancePage(ben);
    await there.open('results');
    await expect(ben.page.getByText('No results yet.')).toBeVisible();
    const file = ben.page.locator('input[type=file]');
    await file.setInputFiles({
      name: 'wrong.json',
      mimeType: 'application/json',
      buffer: Buffer.from('{"a":1}'),
    });
    await expect(ben.page.getByRole('alert')).toContainText(
      'wrong.json: The file contains no performance results.',
    );
    await file.setInputFiles({
      name: 'right.json',
      mimeType: 'application/json',
      buffer: Buffer.from(json.text),
    });
    await expect(there.kept).toHaveCount(2);
    await ben.page.getByRole('button', { name: 'Compare 2' }).click();
    await expect(ben.page.getByRole('article', { name: 'Comparison' })).toBeVisible();
  });

  await test.step('removed, and brought back', async () => {
    await page.open('results');
    await page.page.getByRole('checkbox', { name: 'Select At home' }).check();
    await page.page.getByRole('button', { name: 'Delete' }).click();
    await expect(page.kept).toHaveCount(1);
    await page.page.getByRole('button', { name: 'Undo' }).click();
    await expect(page.kept).toHaveCount(2);
    await page.page.reload();
    await expect(page.kept).toHaveCount(2);
  });
});

test('a phone measures and reads everything without scrolling sideways', async ({ room }) => {
  const ben = await room.withPhone('Ben');
  const page = new PerformancePage(ben);
  await page.open();
  await page.fill(SHORT);
  await page.measure();
  for (const place of PLACES) {
    const link = page.places.getByRole('link', { name: place });
    await link.click();
    await expect(link).toHaveAttribute('aria-current', 'page');
    await expect(ben.page.getByRole('heading', { level: 1 })).toBeVisible();
    const overflow = await ben.page.evaluate(() => {
      const main = document.querySelector('main')!;
      return main.scrollWidth - main.clientWidth;
    });
    expect(overflow, String(place)).toBe(0);
  }
});
