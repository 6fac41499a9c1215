import { openCuttablePort, startNats, type MasterProcess } from '@ubii/harness';
import { createClient } from '@ubii/client-web/node';
import { endMaster, startMaster } from '../../fixtures/start-master.ts';
import { expect, test } from '../../fixtures/test.ts';

test('pages name the master of clients and sessions, list all masters, and say when theirs is alone [CU-70, CU-71, CU-75, CU-95, CU-96]', async ({
  browser,
}) => {
  const nats = await startNats({ jetstream: true });
  const port = await openCuttablePort(nats.port);
  const start = (name: string, url: string): Promise<MasterProcess> =>
    startMaster({ flags: ['--name', name, '--cluster', url] });
  const [hall, foyer] = await Promise.all([
    start('Hall', `nats://127.0.0.1:${port.port}`),
    start('Foyer', nats.url),
  ]);
  const robot = createClient({ url: foyer.url, name: 'Robot' });
  try {
    await robot.connect();
    await robot.call('sessionRuntimeAdd', { name: 'Lights', processingModules: [] });
    const page = await browser.newPage({ baseURL: hall.url });
    await page.goto('/clients');
    const row = page.getByRole('row').filter({ hasText: 'Robot' });
    await expect(row.getByText('Foyer')).toBeVisible();
    await page.goto('/sessions');
    await expect(page.getByRole('listitem').filter({ hasText: 'Lights' })).toContainText('Foyer');
    await page.goto('/settings');
    await page.getByRole('link', { name: 'Masters', exact: true }).click();
    const table = page.getByRole('table', { name: 'Masters' });
    await expect(table.getByRole('row').filter({ hasText: 'Hall' })).toContainText('own master');
    const other = table.getByRole('row').filter({ hasText: 'Foyer' });
    await expect(other).toContainText('connected');
    port.cut();
    const strip = page.getByRole('status', { name: 'Cluster' });
    await expect(strip).toContainText('NATS cannot be reached');
    await expect(other).toContainText('out of reach');
    port.heal();
    await expect(other).toContainText('connected');
    await expect(strip).toBeHidden();
    await page.close();
  } finally {
    await robot.close();
    await Promise.all([endMaster(hall), endMaster(foyer)]);
    await port.close();
    await nats.stop();
  }
});
