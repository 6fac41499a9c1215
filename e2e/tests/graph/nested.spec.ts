import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { placedSession } from '../../fixtures/placed-session.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

const ROW = {
  source: { x: 0, y: 0, writes: '/flow' },
  sink: { x: 700, y: 0, reads: '/flow' },
  loose: { x: 350, y: 300 },
};
const MODULES = { one: { x: 40, y: 60 }, two: { x: 420, y: 60 } };
const FRAMES = {
  'frame:outer': { kind: 'frame', title: 'Outer', x: -20, y: -60, width: 700, height: 420 },
  'frame:inner': { kind: 'frame', title: 'Inner', x: 760, y: 20, width: 260, height: 200 },
};

test('frames hold nodes and other frames', async ({ room, master }) => {
  const anna = await room.atDesk('Anna');
  const graph = new GraphPage(anna);
  const { mouse, keyboard } = anna.page;
  await graph.open(await placedSession(master, ROW));
  await expect(graph.node('Module loose')).toBeVisible();
  await test.step('a frame is made, takes nodes in, lets them go, and is resized', async () => {
    const frame = graph.node('Frame');
    const area = frame.locator('[data-over]');

    await test.step('around what is selected', async () => {
      await graph.fitBesideInspector('Module loose');
      await keyboard.press('Control+g');
      await expect(frame).toBeVisible();
    });

    await test.step('what is in it moves along', async () => {
      const before = await graph.box('Module loose');
      await graph.pullBy(await graph.grip('Frame'), -60, 0);
      await mouse.up();
      await expect
        .poll(async () => (await graph.box('Module loose')).x - before.x)
        .toBeCloseTo(-60, -1);
    });

    await test.step('its corner makes it larger', async () => {
      const { width } = await graph.box('Frame');
      const corner = await graph.middleOf(frame.locator('[data-resize="se"]'));
      await graph.pullBy(corner, 260, 80);
      await mouse.up();
      await expect.poll(async () => (await graph.box('Frame')).width - width).toBeCloseTo(260, -1);
    });

    await test.step('a node dropped in it joins, and moves along', async () => {
      const { x, y, width, height } = await graph.box('Frame');
      const node = await graph.box('Module sink');
      const to = { x: x + width - node.width + 20, y: y + height - node.height - 10 };
      await graph.pull(await graph.grip('Module sink'), to);
      await expect(area).toHaveCount(1);
      await mouse.up();
      await expect(area).toHaveCount(0);
      const joined = await graph.box('Module sink');
      await graph.pullBy(await graph.grip('Frame'), 0, -40);
      await mouse.up();
      await expect
        .poll(async () => (await graph.box('Module sink')).y - joined.y)
        .toBeCloseTo(-40, -1);
    });

    await test.step('and leaves it when it is dragged out', async () => {
      await graph.pullBy(await graph.grip('Module sink'), 20, -260);
      await mouse.up();
      const left = await graph.box('Module sink');
      const before = await graph.box('Frame');
      await graph.pullBy(await graph.grip('Frame'), 0, 40);
      await mouse.up();
      await expect.poll(async () => (await graph.box('Frame')).y - before.y).toBeCloseTo(40, -1);
      expect((await graph.box('Module sink')).y).toBeCloseTo(left.y, 0);
    });

    await test.step('it has a title of its own', async () => {
      const { x, y } = await graph.box('Frame');
      await mouse.dblclick(x + 24, y + 14);
      await anna.page.getByLabel('Title of the frame').fill('Phones');
      await keyboard.press('Enter');
      await expect(graph.node('Frame Phones')).toContainText('Phones');
      await keyboard.press('Control+z');
      await expect(frame).toBeVisible();
    });

    await test.step('without it, what was in it stays', async () => {
      await keyboard.press('Control+Shift+g');
      await expect(frame).toBeHidden();
      await expect(graph.node('Module loose')).toBeVisible();
    });
  });

  await test.step('frames lie in frames: they are dragged in, move together, and are still there after a reload', async () => {
    const id = await placedSession(master, MODULES, FRAMES);
    await graph.open(id);
    await expect(graph.node('Frame Inner')).toBeVisible();
    const yOf = async (node: string): Promise<number> => (await graph.box(node)).y;

    await test.step('the inner one takes a node in, and is dragged into the outer one', async () => {
      await graph.fitBesideInspector('Module two');
      const inner = await graph.box('Frame Inner');
      await graph.pull(await graph.grip('Module two'), { x: inner.x + 60, y: inner.y + 60 });
      await mouse.up();
      const outer = await graph.box('Frame Outer');
      const to = { x: outer.x + outer.width * 0.55, y: outer.y + outer.height * 0.3 };
      await graph.pull(await graph.grip('Frame Inner'), to);
      await expect(graph.node('Frame Outer').locator('[data-over]')).toHaveCount(1);
      await mouse.up();
      await expect(graph.canvas.getByText('Inner', { exact: true })).toBeVisible();
    });

    const before = { frame: 0, node: 0 };
    await test.step('the outer one takes both along, and undo brings both back', async () => {
      before.frame = await yOf('Frame Inner');
      before.node = await yOf('Module two');
      await graph.pullBy(await graph.grip('Frame Outer'), 0, 60);
      await mouse.up();
      await expect.poll(async () => (await yOf('Module two')) - before.node).toBeGreaterThan(40);
      const by = (await yOf('Module two')) - before.node;
      expect((await yOf('Frame Inner')) - before.frame).toBeCloseTo(by, 0);
      await keyboard.press('Control+z');
      await expect.poll(async () => (await yOf('Module two')) - before.node).toBeCloseTo(0, -1);
      await expect.poll(async () => (await yOf('Frame Inner')) - before.frame).toBeCloseTo(0, -1);
    });

    await test.step('what is pointed at in the inner one is the inner one', async () => {
      const { x, y, width } = await graph.box('Frame Inner');
      await mouse.click(x + width - 20, y + 12);
      await expect(graph.inspector.getByRole('heading', { name: 'Inner' })).toBeVisible();
    });

    await test.step('it is saved, and the same after a reload', async () => {
      await graph.life.getByRole('button', { name: /^Save \d/ }).click();
      await expect(graph.life.getByRole('button', { name: /^Save \d/ })).toBeHidden();
      const { session } = await callService(master.endpoints, {
        topic: SERVICES.sessionRuntimeGet.topic,
        session: { id },
      });
      const { nodes } = JSON.parse(session!.extension!.editorJson) as {
        nodes: Record<string, { frame?: string }>;
      };
      expect(nodes['frame:inner']?.frame).toBe('frame:outer');
      await anna.page.reload();
      await expect(graph.node('Frame Inner')).toBeVisible();
      const [frame, node] = [await yOf('Frame Outer'), await yOf('Module two')];
      await graph.pullBy(await graph.grip('Frame Outer'), 0, -40);
      await mouse.up();
      await expect.poll(async () => (await yOf('Frame Outer')) - frame).toBeLessThan(-20);
      const by = (await yOf('Frame Outer')) - frame;
      expect((await yOf('Module two')) - node).toBeCloseTo(by, 0);
    });

    await test.step('without the inner one, what was in it is in the outer one', async () => {
      await graph.node('Frame Inner').focus();
      await keyboard.press('Control+Shift+g');
      await expect(graph.node('Frame Inner')).toBeHidden();
      const node = await yOf('Module two');
      await graph.pullBy(await graph.grip('Frame Outer'), 0, 40);
      await mouse.up();
      await expect.poll(async () => (await yOf('Module two')) - node).toBeGreaterThan(20);
    });
  });
});
