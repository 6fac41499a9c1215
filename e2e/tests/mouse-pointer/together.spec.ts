import { expect, test } from '../../fixtures/test.ts';
import { MousePointerPage } from '../../pages/mouse-pointer-page.ts';

test('two people at desks and one with a phone see each other’s pointers, by name', async ({
  room,
}) => {
  const names = ['Anna', 'Ben', 'Carla'];
  const anna = new MousePointerPage(await room.atDesk('Anna'));
  const ben = new MousePointerPage(await room.atDesk('Ben'));
  await Promise.all([anna.open(), ben.open()]);

  await test.step('a pointer can be moved with the keyboard alone', async () => {
    await anna.pad.focus();
    await expect(async () => {
      await anna.page.keyboard.press('ArrowRight');
      await expect
        .poll(() => ben.positionOf(ben.pointerOf('Anna')), { timeout: 1_000 })
        .toBeDefined();
    }).toPass();
    const before = await ben.positionOf(ben.pointerOf('Anna'));
    for (let press = 0; press < 5; press++) await anna.page.keyboard.press('Shift+ArrowDown');
    await expect
      .poll(async () => (await ben.positionOf(ben.pointerOf('Anna')))?.y)
      .toBeGreaterThan(before!.y + 0.05);
  });

  const places = [
    { x: 0.2, y: 0.3 },
    { x: 0.6, y: 0.5 },
    { x: 0.4, y: 0.8 },
  ] as const;
  await anna.pointTo(places[0]);
  await ben.pointTo(places[1]);
  const carla = new MousePointerPage(await room.withPhone('Carla'));
  const pages = [anna, ben, carla];

  await test.step('somebody who comes later sees where the others’ pointers rest', async () => {
    await carla.open();
    await carla.expectPointer(carla.pointerOf('Anna'), places[0]);
    await carla.expectPointer(carla.pointerOf('Ben'), places[1]);
  });

  await carla.pointTo(places[2]);
  for (const [viewer, page] of pages.entries()) {
    await expect(page.otherPointers).toHaveCount(2);
    for (const [other, name] of names.entries()) {
      if (other !== viewer) await page.expectPointer(page.pointerOf(name), places[other]!);
    }
  }

  await test.step('a finger moves the pointer of a phone, and lifting it leaves the pointer there', async () => {
    await carla.pointTo({ x: 0.7, y: 0.6 });
    await ben.expectPointer(ben.pointerOf('Carla'), { x: 0.7, y: 0.6 });
    await carla.drag({ x: 0.5, y: 0.5 }, { x: 0.3, y: 0.9 });
    await ben.expectPointer(ben.pointerOf('Carla'), { x: 0.3, y: 0.9 });
  });

  await test.step('the pointer disappears when its user opens another page', async () => {
    await anna.page.getByRole('link', { name: 'Topics', exact: true }).click();
    for (const page of [ben, carla]) {
      await expect(page.pointerOf('Anna')).toHaveCount(0);
      await expect(page.otherPointers).toHaveCount(1);
    }
  });

  await test.step('the pointer disappears when its user closes the page [EX-55]', async () => {
    await ben.page.close();
    await expect(carla.otherPointers).toHaveCount(0);
  });
});
