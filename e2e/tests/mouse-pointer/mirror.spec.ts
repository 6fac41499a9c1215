import { expect, test } from '../../fixtures/test.ts';
import { MousePointerPage } from '../../pages/mouse-pointer-page.ts';
import { SessionsPage } from '../../pages/sessions-page.ts';
import { Shell } from '../../pages/shell.ts';

test('one session from this page mirrors the pointer on the master, in this tab and on a node, switched live @smoke', async ({
  room,
}) => {
  const lab = await room.node('Lab');
  const anna = new MousePointerPage(await room.atDesk('Anna'));
  await anna.open();
  await anna.expectMirrorState('Running');
  await anna.pointTo({ x: 0.2, y: 0.3 });
  await anna.expectPointer(anna.mirroredPointer, { x: 0.8, y: 0.3 });

  await test.step('a switch counts at once, without a move', async () => {
    await anna.mirror('y', true);
    await anna.expectPointer(anna.mirroredPointer, { x: 0.8, y: 0.7 });
    await anna.mirror('x', false);
    await anna.expectPointer(anna.mirroredPointer, { x: 0.2, y: 0.7 });
  });

  for (const [place, at] of [
    ['This tab', { x: 0.4, y: 0.2 }],
    ['Master', { x: 0.3, y: 0.4 }],
    ['Node', { x: 0.6, y: 0.1 }],
  ] as const) {
    await test.step(place, async () => {
      await anna.place(place).click();
      await anna.expectMirrorState('Running');
      await anna.pointTo(at);
      await anna.expectPointer(anna.mirroredPointer, { x: at.x, y: 1 - at.y });
      if (place === 'Node') {
        await expect(anna.session.getByRole('combobox', { name: 'Node', exact: true })).toHaveText(
          'Lab',
        );
      }
      if (place === 'This tab') {
        await new Shell(anna.page).expectModulesHere(1);
      }
    });
  }

  await test.step('the node ends', async () => {
    await lab.stop();
    await anna.expectMirrorState('Degraded');
  });
});

test('people mirror their pointers beside each other', async ({ room }) => {
  const carla = await room.atDesk('Carla');
  await carla.page.goto('/settings');
  const runsModules = carla.page.getByRole('switch', { name: /^Run modules in this tab/ });
  await runsModules.click();
  await expect(carla.page.getByRole('status').filter({ hasText: 'Ready' })).toBeVisible();

  const one = await room.atDesk('Anna');
  const anna = new MousePointerPage(one);
  await anna.open();
  await anna.expectMirrorState('Running');

  await test.step('the pointer is mirrored in somebody else’s tab, and the page says when that is gone', async () => {
    await anna.place('Node').click();
    await expect(carla.page.getByRole('status').filter({ hasText: 'Runs 1 module' })).toBeVisible();
    await anna.pointTo({ x: 0.2, y: 0.3 });
    await anna.expectPointer(anna.mirroredPointer, { x: 0.8, y: 0.3 });
    await runsModules.click();
    await anna.expectMirrorState('Degraded');
    await expect(anna.session.getByRole('alert')).toContainText('Carla');
    await anna.place('Master').click();
    await anna.expectMirrorState('Running');
    await anna.pointTo({ x: 0.7, y: 0.3 });
    await anna.expectPointer(anna.mirroredPointer, { x: 0.3, y: 0.3 });
  });

  await test.step('everybody has a session of their own, which ends with their page', async () => {
    const two = await room.withPhone('Ben');
    const ben = new MousePointerPage(two);
    await ben.open();
    await ben.expectMirrorState('Running');
    await anna.pointTo({ x: 0.1, y: 0.5 });
    await ben.pointTo({ x: 0.7, y: 0.5 });
    await anna.expectPointer(anna.mirroredPointer, { x: 0.9, y: 0.5 });
    await ben.expectPointer(ben.mirroredPointer, { x: 0.3, y: 0.5 });

    await new Shell(carla.page).go('Sessions');
    const sessions = new SessionsPage(carla);
    await expect(sessions.link('Mouse pointer of Anna')).toBeVisible();
    await expect(sessions.link('Mouse pointer of Ben')).toBeVisible();

    await test.step('a visit of another page of the program', async () => {
      await new Shell(one.page).go('Home');
      await expect(sessions.link('Mouse pointer of Anna')).toHaveCount(0);
    });
    await test.step('a reload has one session, not two', async () => {
      await two.page.reload();
      await ben.expectMirrorState('Running');
      await expect(sessions.link('Mouse pointer of Ben')).toHaveCount(1);
    });
    await test.step('a closed page', async () => {
      await two.page.close({ runBeforeUnload: false });
      await expect(sessions.link('Mouse pointer of Ben')).toHaveCount(0);
    });
  });
});
