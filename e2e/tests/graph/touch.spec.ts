import type { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';
import { Fingers, middleOf } from '../../pages/touch.ts';

const TABLET = {
  viewport: { width: 1024, height: 768 },
  hasTouch: true,
  isMobile: true,
} as const;

async function aSession(master: MasterProcess, ...names: readonly string[]): Promise<string> {
  const { session } = await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeAdd.topic,
    session: { name: 'Touch', processingModules: names.map((name) => ({ name })) },
  });
  return session!.id;
}

test('a graph is edited with fingers on a tablet', async ({ room, master }) => {
  const { page } = await room.atDesk('Ines', TABLET);
  const graph = new GraphPage({ page });
  const fingers = await Fingers.on(page);
  await test.step('fingers wire, zoom, drag and ask for the menu on a tablet', async () => {
    await graph.open(await aSession(master, 'clock', 'low-pass'));
    const lowPass = graph.node('Module low-pass');
    const value = graph.socket('Module low-pass', 'Input value');

    await test.step('tap and tap makes a wire, and cancel stops it', async () => {
      const hint = page.getByText('Tap the target');
      await fingers.tapOn(graph.socket('Module clock', 'Output sine'));
      await expect(hint).toBeVisible();
      await page.getByRole('button', { name: 'Cancel' }).tap();
      await expect(hint).toBeHidden();
      await fingers.tapOn(graph.socket('Module clock', 'Output sine'));
      await expect(hint).toBeVisible();
      await fingers.tapOn(value);
      await expect(value).toHaveAccessibleName(/1 connected/);
      await expect(hint).toBeHidden();
    });

    await test.step('one finger pans, and drags a node', async () => {
      const before = (await lowPass.boundingBox())!;
      const spot = await graph.spot(0.5, 0.8);
      await fingers.drag(spot, { x: spot.x, y: spot.y - 60 });
      await expect
        .poll(async () => (await lowPass.boundingBox())!.y - before.y)
        .toBeCloseTo(-60, -1);
      const now = (await lowPass.boundingBox())!;
      const head = { x: now.x + now.width / 2, y: now.y + 20 };
      await fingers.drag(head, { x: head.x - 40, y: head.y + 50 });
      await expect.poll(async () => (await lowPass.boundingBox())!.y - now.y).toBeGreaterThan(30);
    });

    await test.step('two fingers zoom around the place between them', async () => {
      const before = (await lowPass.boundingBox())!;
      const { x, y } = await graph.spot(0.5, 0.5);
      await fingers.pinch(
        [
          { x: x - 40, y },
          { x: x + 40, y },
        ],
        [
          { x: x - 60, y },
          { x: x + 60, y },
        ],
      );
      await expect
        .poll(async () => (await lowPass.boundingBox())!.width / before.width)
        .toBeCloseTo(1.5, 1);
      const after = (await lowPass.boundingBox())!;
      expect(after.x - x).toBeCloseTo((before.x - x) * 1.5, -1);
      expect(await page.evaluate(() => visualViewport?.scale)).toBe(1);
    });

    await test.step('holding still asks for the menu', async () => {
      const now = (await lowPass.boundingBox())!;
      await fingers.hold({ x: now.x + now.width / 2, y: now.y + 20 }, () =>
        expect(graph.menu).toBeVisible(),
      );
      await expect(graph.menu).toBeVisible();
      await graph.menuItem('Bypass').tap();
      await expect(lowPass).toContainText('bypassed');
    });

    await test.step('several nodes are selected, and removed', async () => {
      const now = (await lowPass.boundingBox())!;
      await fingers.hold({ x: now.x + now.width / 2, y: now.y + 20 }, () =>
        expect(graph.menu).toBeVisible(),
      );
      await graph.menuItem('Select multiple').tap();
      await expect(page.getByText('1 selected.')).toBeVisible();
      const clock = (await graph.node('Module clock').boundingBox())!;
      await fingers.tap({ x: clock.x + clock.width / 2, y: clock.y + 20 });
      await expect(page.getByText('2 selected.')).toBeVisible();
      await page.getByRole('button', { name: 'Done' }).tap();
    });
  });

  await test.step('a topic of the palette is dragged onto an input with a finger', async () => {
    const wave = await room.program('wave');
    wave.publish('/wave/height', 'double', 4);
    await graph.open(await aSession(master, 'low-pass'));
    const value = graph.socket('Module low-pass', 'Input value');
    await expect(value).toBeVisible();
    const topic = graph.paletteTopic('/wave/height');
    await expect(topic).toBeVisible();
    await fingers.drag(await middleOf(topic), await middleOf(value));
    await expect(value).toHaveAccessibleName(/1 connected/);
  });
});
