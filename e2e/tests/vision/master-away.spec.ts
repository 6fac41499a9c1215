import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';

/** Console messages of the browser itself while the master is unreachable. */
const UNREACHABLE = [/net::ERR_CONNECTION_(REFUSED|RESET)/, /WebSocket connection to .* failed/];
const OLD = 'Received before the connection was lost';

test('the last results stay while the master is away, marked as old, and nothing looks live', async ({
  master,
  room,
}) => {
  const { page, watch } = await room.atDesk('Anna');
  const { disconnectedStrip } = new Shell(page);
  const aside = page.getByRole('complementary', { name: 'Object detection' });
  const way = page.getByRole('region', { name: 'Latency from camera to screen' });
  const looked = page.locator('.funnel > div').filter({ hasText: 'Processed' });
  await page.goto('/examples/object-detection');
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await expect(aside.getByRole('region', { name: 'Detected now' })).toContainText('cup');
  await expect(way).toContainText('Detect');

  watch.expect(...UNREACHABLE);
  await master.stop();
  // Results count for 3 s while the master is there: that time is over.
  await expect(disconnectedStrip).toContainText('try 6', { timeout: 30_000 });
  await expect(disconnectedStrip).toContainText('The page shows the last values that it received.');
  const seen = aside.getByRole('region', { name: 'Last detected' });
  await expect(seen).toContainText(OLD);
  await expect(seen.getByRole('listitem').first()).toBeVisible();
  await expect(way).toContainText(OLD);
  await expect(way).toContainText('Detect');
  await expect(looked).toContainText('–');
  await expect(page.locator('[data-label]')).toHaveCount(0);
  await expect(aside).toContainText('No pictures are sent: this page is not connected.');

  await master.restart();
  await expect(
    aside.getByRole('region', { name: 'Detected now' }).getByRole('listitem'),
  ).not.toHaveCount(0, { timeout: 60_000 });
  await expect(page.getByText(OLD)).toHaveCount(0);
});
