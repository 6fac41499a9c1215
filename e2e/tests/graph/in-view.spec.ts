import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

test('the editor stays in view, however long the lists of its palette are', async ({
  room,
  master,
}) => {
  const { sessionList } = await callService(master.endpoints, {
    topic: SERVICES.sessionDatabaseSave.topic,
    session: { name: 'Chain', processingModules: [{ name: 'threshold' }] },
  });
  const { page } = await room.atDesk('Anna');
  await page.setViewportSize({ width: 1440, height: 900 });
  const graph = new GraphPage({ page });
  await graph.open(sessionList!.elements[0]!.id);
  await expect(graph.palette.locator('[data-palette-module]').last()).toBeAttached();
  const list = graph.palette.getByRole('region', { name: /^Modules/ }).locator('.list');
  const isLong = await list.evaluate((one) => one.scrollHeight > one.clientHeight);
  expect(isLong, 'the modules are more than there is room for').toBe(true);
  await graph.inspector.hover();
  await page.mouse.wheel(0, 1000);
  const main = page.getByRole('main');
  expect(await main.evaluate((one) => one.scrollHeight - one.clientHeight)).toBe(0);
});
