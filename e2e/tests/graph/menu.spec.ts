import type { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

/** A clock that feeds a low-pass. */
async function aChain(master: MasterProcess): Promise<string> {
  const { session } = await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeAdd.topic,
    session: {
      name: 'Menu',
      processingModules: [
        { id: '10000000-0000-4000-8000-000000000001', name: 'clock' },
        { id: '10000000-0000-4000-8000-000000000002', name: 'low-pass' },
      ],
      ioMappings: [
        {
          processingModuleId: '10000000-0000-4000-8000-000000000001',
          outputMappings: [{ outputName: 'sine', topic: '/sine' }],
        },
        {
          processingModuleId: '10000000-0000-4000-8000-000000000002',
          inputMappings: [{ inputName: 'value', topic: '/sine' }],
        },
      ],
    },
  });
  return session!.id;
}

test('menus of the graph are used with the mouse and with keys', async ({ room, master }) => {
  const { page } = await room.atDesk('Anna');
  const graph = new GraphPage({ page });
  await graph.open(await aChain(master));
  const lowPass = graph.node('Module low-pass');
  await test.step('the right mouse button offers what can be done, with a node, a wire, a socket and the canvas', async () => {
    const value = graph.socket('Module low-pass', 'Input value');
    await expect(value).toHaveAccessibleName(/1 connected/);

    await test.step('a module is bypassed, and undo takes it back', async () => {
      await lowPass.click({ button: 'right', position: { x: 80, y: 14 } });
      await graph.menuItem('Bypass').click();
      await expect(lowPass).toContainText('bypassed');
      await expect(graph.menu).toBeHidden();
      await page.keyboard.press('Control+z');
      await expect(lowPass).not.toContainText('bypassed');
    });

    await test.step('it collapses to its header, with its wire, and opens again', async () => {
      await lowPass.click({ button: 'right', position: { x: 80, y: 14 } });
      await graph.menuItem('Collapse').click();
      await expect.poll(async () => (await lowPass.boundingBox())!.height).toBeLessThan(40);
      await expect(value).toHaveAccessibleName(/1 connected/);
      await page.keyboard.press('c');
      await expect.poll(async () => (await lowPass.boundingBox())!.height).toBeGreaterThan(60);
    });

    await test.step('two nodes are lined up', async () => {
      await page.keyboard.press('Control+a');
      await lowPass.click({ button: 'right', position: { x: 80, y: 14 } });
      await graph.menuItem('Align').hover();
      await graph.menuItem('Top edges').click();
      const clock = graph.node('Module clock');
      await expect
        .poll(async () => (await lowPass.boundingBox())!.y - (await clock.boundingBox())!.y)
        .toBeCloseTo(0, 0);
    });

    await test.step('a module goes into the wire', async () => {
      await graph.pointAtWire('right');
      await graph.menuItem('Insert module…').click();
      const search = page.getByRole('combobox', { name: 'Insert on the wire' });
      await search.fill('map-range');
      await search.press('Enter');
      await expect(graph.node('Module map-range')).toBeVisible();
      await expect(value).toHaveAccessibleName(/1 connected/);
      await page.keyboard.press('Control+z');
      await expect(graph.node('Module map-range')).toBeHidden();
    });

    await test.step('a socket gives up its wire', async () => {
      await value.click({ button: 'right' });
      await graph.menuItem('Disconnect').click();
      await expect(value).toHaveAccessibleName(/not connected/);
      await page.keyboard.press('Control+z');
      await expect(value).toHaveAccessibleName(/1 connected/);
    });

    await test.step('nodes are copied, and pasted where the menu was asked for', async () => {
      await lowPass.click({ button: 'right', position: { x: 80, y: 14 } });
      await graph.menuItem('Copy').click();
      await expect(graph.menu).toBeHidden();
      const spot = await graph.spot(0.2, 0.85);
      await page.mouse.click(spot.x, spot.y, { button: 'right' });
      await graph.menuItem('Paste').click();
      await expect(lowPass).toHaveCount(2);
    });
  });

  await graph.startAgain();
  await test.step('the menu key does the same without a mouse, and Escape leads back', async () => {
    await lowPass.focus();

    await page.keyboard.press('Shift+F10');
    await expect(graph.menu).toBeVisible();
    await page.keyboard.press('Escape');
    await expect(graph.menu).toBeHidden();
    await expect(lowPass).toBeFocused();

    await page.keyboard.press('ContextMenu');
    await expect(graph.menu).toBeVisible();
    await page.keyboard.press('m');
    await expect(graph.menuItem('Mute')).toBeFocused();
    await page.keyboard.press('Enter');
    await expect(lowPass).toContainText('muted');
    await page.keyboard.press('Shift+F10');
    await page.keyboard.press('ArrowUp');
    await expect(graph.menuItem('Delete')).toBeFocused();
    await page.keyboard.press('Enter');
    await expect(lowPass).toBeHidden();
    await page.keyboard.press('Control+z');
    await expect(lowPass).toBeVisible();
  });
});
