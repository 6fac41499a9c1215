import { expect, test } from '../../fixtures/test.ts';
import { PerformancePage } from '../../pages/performance-page.ts';

test('the round trip is measured, immediate and aggregated', async ({ room }) => {
  const page = new PerformancePage(await room.atDesk('Anna'));
  await page.open();
  await expect(page.page.getByText('No results yet.')).toBeVisible();

  await test.step('what is not filled in as it should be is said beside the field, and nothing starts', async () => {
    await page.fill({ Rate: '9999' });
    await expect(page.page.getByRole('alert')).toContainText('Enter a whole number from 1 to 200.');
    await expect(page.start).toHaveAttribute('aria-disabled', 'true');
    await page.fill({ Rate: '40' });
    await expect(page.start).not.toHaveAttribute('aria-disabled', 'true');
  });

  await page.fill({ 'Duration of each': '1' });
  await page.measure();
  for (const way of ['immediate', 'aggregated']) {
    expect(await page.figureValue(`${way}.sent`)).toBeGreaterThan(0);
    expect(await page.figureValue(`${way}.lost`)).toBe(0);
    expect(await page.figureValue(`${way}.returned`)).toBe(await page.figureValue(`${way}.sent`));
    await expect(page.figure(`${way}.p95`)).toContainText('ms');
    await expect(page.figure(`${way}.jitter`)).toContainText('ms');
  }
  const chart = page.chart('Immediate: round trips');
  await expect(chart.locator('canvas')).toBeVisible();
  await expect(chart).toContainText(/Most often between .* ms/);

  await test.step('a value is read with the keyboard', async () => {
    const frame = chart.getByRole('img');
    await frame.focus();
    await frame.press('End');
    await frame.press('ArrowLeft');
    await expect(chart.locator('output')).toContainText('%');
  });
});

test('load and screen are measured', async ({ room }) => {
  const page = new PerformancePage(await room.atDesk('Anna'));

  await test.step('the load is raised, and the page says who was the limit', async () => {
    await page.open('load');
    await page.fill({
      Size: '64',
      Clients: '2',
      'Lowest rate': '50',
      'Highest rate': '200',
      'Factor per step': '2',
      'Duration of a step': '1',
    });
    await page.measure();
    expect(await page.figureValue('peak')).toBeGreaterThan(0);
    await expect(page.page.getByRole('list', { name: 'Notes' })).toContainText(
      /records per second/,
    );
    await expect(page.chart('Latency by rate').locator('canvas')).toBeVisible();
    await expect(page.chart('CPU load').locator('canvas')).toBeVisible();
  });

  await test.step('values are timed until they are drawn', async () => {
    await page.places.getByRole('link', { name: 'Topic to screen' }).click();
    await page.fill({ Duration: '1' });
    await page.measure();
    expect(await page.figureValue('drawn')).toBeGreaterThan(0);
    expect(await page.figureValue('lost')).toBe(0);
    await expect(page.chart('Published to drawn').first().locator('canvas')).toBeVisible();
  });
});

test('the speed of sessions is measured', async ({ room }) => {
  await room.node('Lab');
  const page = new PerformancePage(await room.atDesk('Anna'));
  await page.open('session-speed');
  await page.fill({ Modules: '2', 'Additions per run': '1000', Duration: '1' });
  // The result of the run before is there until the next one has ended.
  const expectResultOf = (name: string | RegExp) =>
    expect(page.page.getByRole('article', { name })).toBeVisible();

  for (const mode of ['Trigger on input', 'Lockstep', 'Free', 'Frequency']) {
    await test.step(`modules run on the master, ${mode}`, async () => {
      await page.page.getByRole('radio', { name: mode, exact: true }).click();
      await page.measure();
      await expectResultOf(new RegExp(`^Session speed: .*, ${mode}$`));
      expect(await page.figureValue('runs')).toBeGreaterThan(0);
      expect(await page.figureValue('errors')).toBe(0);
      await expect(page.figure('echo.p50')).toContainText('ms');
      if (mode === 'Lockstep') await expect(page.figure('pass.p50')).toContainText('ms');
    });
  }

  await test.step('modules run in this tab and on a node', async () => {
    for (const place of ['This tab', 'Lab']) {
      await test.step(place, async () => {
        await page.page.getByRole('combobox', { name: 'Runs on' }).click();
        await page.page.getByRole('option', { name: place }).click();
        await page.measure();
        await expectResultOf(`Session speed: ${place}, Frequency`);
        expect(await page.figureValue('runs')).toBeGreaterThan(0);
      });
    }
  });
});
