import type { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

/** A session with one module. */
async function aChain(master: MasterProcess): Promise<string> {
  const { session } = await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeAdd.topic,
    session: { name: 'Chain', processingModules: [{ name: 'low-pass' }] },
  });
  return session!.id;
}

test('two people change one session, and nothing is lost @smoke', async ({ room, master }) => {
  const id = await aChain(master);
  const anna = new GraphPage(await room.atDesk('Anna'));
  const ben = new GraphPage(await room.atDesk('Ben'));
  await anna.open(id);
  await ben.open(id);

  await anna.drag(anna.paletteModule('threshold'), await anna.spot(0.6, 0.2));
  await expect(anna.node('Module threshold')).toBeVisible();
  await ben.drag(ben.paletteModule('statistics'), await ben.spot(0.6, 0.8));
  await ben.life.getByRole('button', { name: 'Save 1 change' }).click();

  await expect(anna.node('Module statistics')).toBeVisible();
  await expect(anna.node('Module threshold')).toBeVisible();
  await expect(anna.page.getByRole('alert')).toContainText('Ben saved');
  await anna.life.getByRole('button', { name: 'Save 1 change' }).click();
  await expect(ben.node('Module threshold')).toBeVisible();
});

test('work that was not saved survives a reload', async ({ room, master }) => {
  const id = await aChain(master);
  const anna = new GraphPage(await room.atDesk('Anna'));
  await anna.open(id);
  await anna.drag(anna.paletteModule('threshold'), await anna.spot(0.6, 0.2));
  await expect(anna.node('Module threshold')).toBeVisible();
  await anna.page.reload();
  await anna.page.getByRole('button', { name: 'Restore changes' }).click();
  await expect(anna.node('Module threshold')).toBeVisible();
  await anna.life.getByRole('button', { name: 'Save 1 change' }).click();
  await expect(anna.life.getByRole('button', { name: /^Save(?! and)/ })).toBeHidden();
  await anna.page.reload();
  await expect(anna.node('Module threshold')).toBeVisible();
  await expect(anna.page.getByRole('button', { name: 'Restore changes' })).toBeHidden();
});

test('a module that fails says so on its node, with the line', async ({ room, master }) => {
  const { session } = await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeAdd.topic,
    session: {
      name: 'Broken',
      processingModules: [
        {
          name: 'thrower',
          processingMode: { frequency: { hertz: 10 } },
          onProcessingStringified: "() => {\n  throw new Error('no model');\n}",
        },
      ],
    },
  });
  const anna = new GraphPage(await room.atDesk('Anna'));
  await anna.open(session!.id);
  await anna.life.getByRole('button', { name: 'Start' }).click();
  await expect(anna.node('Module thrower')).toContainText('no model');
  await expect(anna.node('Module thrower')).toContainText('onProcessing:2');
});

test('a wire is made with the keyboard alone', async ({ room, master }) => {
  const { session } = await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeAdd.topic,
    session: { name: 'Keys', processingModules: [{ name: 'clock' }, { name: 'low-pass' }] },
  });
  const anna = new GraphPage(await room.atDesk('Anna'));
  await anna.open(session!.id);
  await anna.socket('Module clock', 'Output sine').focus();
  await anna.page.keyboard.press('Enter');
  await anna.socket('Module low-pass', 'Input value').focus();
  await anna.page.keyboard.press('Enter');
  await expect(anna.socket('Module low-pass', 'Input value')).toHaveAccessibleName(/1 connected/);

  await test.step('and nodes are moved and removed with it', async () => {
    const node = anna.node('Module low-pass');
    await node.focus();
    const before = await node.boundingBox();
    await anna.page.keyboard.press('Shift+ArrowDown');
    await expect.poll(async () => (await node.boundingBox())!.y - before!.y).toBeGreaterThan(5);
    await anna.page.keyboard.press('Delete');
    await expect(node).toBeHidden();
    await anna.page.keyboard.press('Control+z');
    await expect(node).toBeVisible();
  });
});

test('on a phone the graph is a list, with its life', async ({ room, master }) => {
  const id = await aChain(master);
  const { page } = await room.withPhone('Ines');
  await page.goto(`/sessions/${id}/graph`);
  const list = page.getByRole('list', { name: 'Nodes of the graph' });
  await expect(list).toContainText('low-pass');
  await page.getByRole('button', { name: 'Start' }).tap();
  await expect(page.getByRole('toolbar', { name: 'Session controls' })).toContainText('Running');
  await page.getByRole('button', { name: 'Show as a graph' }).tap();
  await expect(page.getByRole('group', { name: 'Module low-pass' })).toBeVisible();
});
