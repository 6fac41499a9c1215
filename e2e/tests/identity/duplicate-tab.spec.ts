import { expect, test } from '../../fixtures/test.ts';
import { MousePointerPage } from '../../pages/mouse-pointer-page.ts';
import { Shell } from '../../pages/shell.ts';

test('a reload is the same client, a duplicated tab is another', async ({ room }) => {
  const anna = await room.atDesk('Anna');
  const first = new MousePointerPage(anna);
  await first.open();
  await first.pointTo({ x: 0.3, y: 0.3 });

  await test.step('a reload comes back as the same client', async () => {
    const id = await first.ownId();
    await first.page.reload();
    await first.pointTo({ x: 0.4, y: 0.4 });
    expect(await first.ownId()).toBe(id);
    await expect(first.otherPointers).toHaveCount(0);
  });

  await test.step('a duplicated tab is somebody else, and the first goes on', async () => {
    // Duplicating a tab copies its session storage, as opening a window from it does.
    const opening = anna.context.waitForEvent('page');
    await anna.page.evaluate(() => void window.open(location.href, '_blank', 'opener'));
    const second = new MousePointerPage({ page: await opening });
    await second.pointTo({ x: 0.6, y: 0.6 });

    expect(await second.ownId()).not.toBe(await first.ownId());
    await expect(new Shell(first.page).disconnectedStrip).toBeHidden();
    await first.pointTo({ x: 0.2, y: 0.8 });
    await expect(second.otherPointers).toHaveCount(1);
    await second.expectPointer(second.otherPointers, { x: 0.2, y: 0.8 });
  });
});
