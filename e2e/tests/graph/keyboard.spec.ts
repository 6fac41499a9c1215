import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

test('a session is built, wired, started and saved with the keyboard alone @smoke @firefox', async ({
  room,
  master,
}) => {
  const { session } = await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeAdd.topic,
    session: { name: 'By keys' },
  });
  const { page } = await room.atDesk('Anna');
  const graph = new GraphPage({ page });
  await graph.open(session!.id);
  const { keyboard } = page;
  const status = graph.canvas.getByRole('status').first();

  await test.step('the canvas is at most five Tabs away', async () => {
    const skip = page.getByRole('link', { name: 'Skip to the graph' });
    let tabs = 0;
    do {
      await keyboard.press('Tab');
      tabs += 1;
    } while (tabs < 5 && !(await skip.evaluate((link) => link === document.activeElement)));
    await expect(skip).toBeFocused();
    await keyboard.press('Enter');
    await expect(graph.canvas).toBeFocused();
  });

  const add = async (name: string): Promise<void> => {
    await keyboard.press('a');
    await expect(page.getByRole('combobox', { name: 'Add to the graph' })).toBeFocused();
    await keyboard.type(name);
    await expect(page.getByRole('option').first()).toContainText(name);
    await keyboard.press('Enter');
    await expect(graph.node(`Module ${name}`)).toBeFocused();
  };
  await test.step('modules are added beside each other', async () => {
    await add('clock');
    await add('low-pass');
    const [a, b] = [await graph.box('Module clock'), await graph.box('Module low-pass')];
    expect(b.x >= a.x + a.width || b.y >= a.y + a.height).toBe(true);
  });

  await test.step('arrow keys go from node to node and to sockets', async () => {
    await keyboard.press('ArrowLeft');
    await expect(page.locator('.socket:focus')).toHaveAccessibleName(/^Input /);
    await keyboard.press('Escape');
    await expect(graph.node('Module low-pass')).toBeFocused();
    await keyboard.press('ArrowLeft');
    await keyboard.press('ArrowLeft');
    await expect(graph.node('Module clock')).toBeFocused();
    await keyboard.press('ArrowRight');
    await expect(page.locator('.socket:focus')).toHaveAccessibleName(/^Output .*not connected/);
  });

  await test.step('L starts a wire, typing finds the socket, Enter connects', async () => {
    await graph.socket('Module clock', 'Output sine').focus();
    await keyboard.press('l');
    const list = page.getByRole('combobox', { name: 'Connect clock · sine to' });
    await expect(list).toBeFocused();
    await keyboard.press('Escape');
    await expect(graph.socket('Module clock', 'Output sine')).toBeFocused();
    await keyboard.press('l');
    await keyboard.type('low value');
    await expect(page.getByRole('option').first()).toContainText('low-pass · value');
    await keyboard.press('Enter');
    await expect(graph.socket('Module clock', 'Output sine')).toHaveAccessibleName(
      /1 connected: low-pass · value$/,
    );
    await expect(graph.socket('Module clock', 'Output sine')).toBeFocused();
  });

  await test.step('a result goes to a topic of its own', async () => {
    await keyboard.press('ArrowRight');
    await expect(graph.socket('Module low-pass', 'Input value')).toBeFocused();
    await keyboard.press('ArrowRight');
    await expect(graph.node('Module low-pass')).toBeFocused();
    await keyboard.press('l');
    await expect(
      page.getByRole('combobox', { name: 'Connect low-pass · smoothed to' }),
    ).toBeFocused();
    await keyboard.type('/by/keys');
    await expect(page.getByRole('option', { name: 'New topic /by/keys' })).toBeVisible();
    await keyboard.press('Enter');
    await expect(graph.node('Topic /by/keys')).toBeVisible();
  });

  await test.step('nodes are moved, removed and brought back', async () => {
    await keyboard.press('Escape');
    await expect(graph.node('Module low-pass')).toBeFocused();
    const before = await graph.box('Module low-pass');
    await keyboard.press('Control+Shift+ArrowDown');
    await expect.poll(async () => (await graph.box('Module low-pass')).y).toBeGreaterThan(before.y);
    await keyboard.press('Delete');
    await expect(graph.node('Module low-pass')).toBeHidden();
    await keyboard.press('Control+z');
    await expect(graph.node('Module low-pass')).toBeVisible();
    await expect(status).toHaveText(/^Undone: Delete low-pass/);
  });

  await test.step('it is started and saved, and its values are seen', async () => {
    // The focused socket after wiring: Enter alone would start a wire there.
    await graph.socket('Module low-pass', 'Output smoothed').focus();
    await keyboard.press('Control+Enter');
    await expect(graph.life).toContainText('Running');
    await expect(graph.life.getByRole('button', { name: /^(Save|Apply)/ })).toBeHidden();
    await expect(graph.node('Topic /by/keys')).toContainText(/\d\.\d/);
    await keyboard.press('ArrowRight');
    await expect(graph.canvas.locator(':focus')).toBeVisible();
    await keyboard.press('Control+Shift+Enter');
    await expect(graph.life).toContainText('Stopped');
  });
});
