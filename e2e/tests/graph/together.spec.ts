import type { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { placedSession, type PlacedModule } from '../../fixtures/placed-session.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';
import { Shell } from '../../pages/shell.ts';

/** Nothing is wired to the third one. */
const FLOW: Readonly<Record<string, PlacedModule>> = {
  source: { x: 0, y: 0, writes: '/flow' },
  sink: { x: 700, y: 0, reads: '/flow' },
  loose: { x: 350, y: 300 },
};

/** A session with one module. */
async function aChain(master: MasterProcess): Promise<string> {
  const { session } = await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeAdd.topic,
    session: { name: 'Chain', processingModules: [{ name: 'low-pass' }] },
  });
  return session!.id;
}

/** A session that is kept on the disk. */
async function aStoredSession(master: MasterProcess): Promise<string> {
  const { sessionList } = await callService(master.endpoints, {
    topic: SERVICES.sessionDatabaseSave.topic,
    session: { name: 'Chain', processingModules: [{ name: 'threshold' }, { name: 'statistics' }] },
  });
  return sessionList!.elements[0]!.id;
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

test('two people see what the other does in the same graph [EX-49]', async ({ room, master }) => {
  const anna = new GraphPage(await room.atDesk('Anna'));
  const benDesk = await room.atDesk('Ben');
  const ben = new GraphPage(benDesk);
  await test.step('a node that somebody else removes in the middle of a drag is let go of', async () => {
    const id = await placedSession(master, FLOW);
    await Promise.all([anna.open(id), ben.open(id)]);
    await expect(anna.node('Module loose')).toBeVisible();
    await anna.fitBesideInspector('Module sink');
    const before = await anna.box('Module sink');

    await anna.page.keyboard.press('Control+a');
    await anna.pullBy(await anna.grip('Module loose'), 40, 40);

    await ben.node('Module loose').focus();
    await ben.page.keyboard.press('Delete');
    await ben.life.getByRole('button', { name: 'Save 1 change' }).click();
    await expect(anna.node('Module loose')).toBeHidden();

    await test.step('the others are where they were, and go on', async () => {
      await anna.page.mouse.move(700, 500);
      await anna.page.mouse.up();
      await expect.poll(async () => (await anna.box('Module sink')).x).toBeCloseTo(before.x, -1);
      await expect(anna.life.getByRole('button', { name: /^Save(?! and)/ })).toBeHidden();
      await anna.pullBy(await anna.grip('Module sink'), -50, 100);
      await anna.page.mouse.up();
      await expect
        .poll(async () => (await anna.box('Module sink')).x - before.x)
        .toBeCloseTo(-50, -1);
      await anna.life.getByRole('button', { name: 'Save 1 change' }).click();
      await expect(anna.life.getByRole('button', { name: /^Save(?! and)/ })).toBeHidden();
    });
  });

  await test.step('two people see each other, what they are at, and when one leaves [EX-49]', async () => {
    const id = await aStoredSession(master);
    await anna.open(id);
    await expect(anna.others).toBeHidden();
    await ben.open(id);
    await expect(anna.others).toContainText('Ben is here');
    await expect(ben.others).toContainText('Anna is here');
    await ben.node('Module statistics').focus();
    await expect(anna.others).toContainText('Ben is at statistics');
    await expect(anna.page.locator('[data-peer="Ben"]')).toBeVisible();

    await test.step('what both changed is decided by hand', async () => {
      await anna.describe('Of Anna');
      await expect(ben.others).toContainText('Anna is editing');
      await ben.describe('Of Ben');
      await ben.page.keyboard.press('Control+s');
      const conflicts = anna.page.getByRole('list', { name: 'Conflicts' });
      await expect(anna.page.getByRole('alert')).toContainText('Ben saved');
      await conflicts.getByRole('button', { name: /Of Ben/ }).click();
      await expect(anna.page.getByRole('region', { name: 'About this session' })).toContainText(
        'Of Ben',
      );
    });

    await test.step('on another page, Ben is not here any more', async () => {
      await new Shell(ben.page).go('Home');
      await expect(anna.others).toBeHidden();
      await ben.open(id);
      await expect(anna.others).toContainText('Ben');
      await benDesk.context.close();
      await expect(anna.others).toBeHidden();
    });
  });
});

test('work that was not saved survives a reload', async ({ room, master }) => {
  const anna = new GraphPage(await room.atDesk('Anna'));
  const id = await aChain(master);
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
