import { placedSession } from '../../fixtures/placed-session.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

test('palette, list and canvas share the room of the window', async ({ master, room }) => {
  const { page } = await room.atDesk('Anna');
  const graph = new GraphPage({ page });
  const modules = { first: { x: 0, y: 0, writes: '/a' }, second: { x: 320, y: 0, reads: '/a' } };
  await graph.open(await placedSession(master, modules));
  await test.step('the editor stays in view, however long the lists of its palette are', async () => {
    await expect(graph.palette.locator('[data-palette-module]').last()).toBeAttached();
    const list = graph.palette.getByRole('region', { name: /^Modules/ }).locator('.list');
    const isLong = await list.evaluate((one) => one.scrollHeight > one.clientHeight);
    expect(isLong, 'the modules are more than there is room for').toBe(true);
    await graph.canvas.hover({ position: { x: 400, y: 700 } });
    await page.mouse.wheel(0, 1000);
    const main = page.getByRole('main');
    expect(await main.evaluate((one) => one.scrollHeight - one.clientHeight)).toBe(0);
  });

  await test.step('the palette is made wider with mouse or keys, which is remembered', async () => {
    const edge = page.getByRole('separator', { name: 'Width of the palette' });
    const width = async (): Promise<number> => (await graph.palette.boundingBox())!.width;
    const before = await width();
    const { x, y } = (await edge.boundingBox())!;
    await page.mouse.move(x + 4, y + 200);
    await page.mouse.down();
    await page.mouse.move(x + 84, y + 200, { steps: 4 });
    await page.mouse.up();
    await expect.poll(width).toBeCloseTo(before + 80, 0);
    await edge.focus();
    await page.keyboard.press('ArrowRight');
    await expect.poll(width).toBeCloseTo(before + 96, 0);
    await page.reload();
    await expect(edge).toHaveAttribute('aria-valuenow', String(Math.round(before + 96)));
  });

  await test.step('on a wide screen the list has the room of the canvas, and prefers topics that exist', async () => {
    const ines = await room.withPhone('Ines');
    await ines.page.goto('/examples/mouse-pointer');
    await ines.page.getByRole('application', { name: 'Pointer pad' }).tap();

    await graph.chooseTool('Show as a list');
    const list = page.getByRole('list', { name: 'Nodes of the graph' });
    const { innerWidth } = await page.evaluate(() => ({ innerWidth: window.innerWidth }));

    await test.step('nodes are wide enough to be read, and the bar stays inside', async () => {
      const node = await list.getByRole('listitem').first().boundingBox();
      expect(node!.width).toBeGreaterThan(320);
      const [bar, rows] = [await graph.life.boundingBox(), await list.boundingBox()];
      expect(rows!.width).toBeGreaterThan(innerWidth / 3);
      expect(bar!.x).toBeGreaterThanOrEqual(rows!.x);
      expect(bar!.x + bar!.width).toBeLessThanOrEqual(rows!.x + rows!.width);
    });

    await test.step('a topic of a client goes by its name, and is found by it', async () => {
      await list
        .getByRole('button', { name: /^Input value/ })
        .first()
        .click();
      const field = page.getByRole('combobox', { name: 'Find source or topic' });
      await field.fill('ines position');
      const first = page.getByRole('option').first();
      await expect(first).toContainText(
        /mouse_(client|server)_position.*Ines · web-example-mouse-pointer/,
      );
      await expect(first).not.toContainText(/[0-9a-f]{8}-/);
      await page.keyboard.press('Escape');
    });
    await test.step('a name that is typed in part finds what exists', async () => {
      await list
        .getByRole('button', { name: /^Input value/ })
        .first()
        .click();
      await page.getByRole('combobox', { name: 'Find source or topic' }).fill('second');
      await page.keyboard.press('Enter');
      await expect(list.getByRole('button', { name: /^Input value/ }).first()).toContainText(
        'second · result',
      );
    });
  });
});
