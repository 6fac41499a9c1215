import { placedSession } from '../../fixtures/placed-session.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';
import { Pen } from '../../pages/pen.ts';

const TABLET = { viewport: { width: 1024, height: 768 }, hasTouch: true } as const;
const MODULES = { source: { x: 0, y: 0 }, sink: { x: 340, y: 60 } };

test('a pen drags nodes, pulls wires, moves the canvas and asks for the menu', async ({
  room,
  master,
}) => {
  const { page } = await room.atDesk('Ines', TABLET);
  const graph = new GraphPage({ page });
  const pen = await Pen.on(page);
  await graph.open(await placedSession(master, MODULES));
  const sink = graph.node('Module sink');
  const input = graph.socket('Module sink', 'Input value');
  const output = graph.socket('Module source', 'Output result');
  await expect(sink).toBeVisible();
  const place = () => graph.box('Module sink');

  await test.step('a node follows it', async () => {
    const before = await place();
    const grip = await graph.grip('Module sink');
    await pen.drag(grip, { x: grip.x + 60, y: grip.y + 80 });
    await expect.poll(async () => (await place()).y - before.y).toBeGreaterThan(60);
    await expect(graph.menu).toBeHidden();
    await page.keyboard.press('Control+z');
    await expect.poll(async () => (await place()).y - before.y).toBeCloseTo(0, -1);
  });

  await test.step('a wire follows it to an input', async () => {
    await pen.drag(await graph.middleOf(output), await graph.middleOf(input));
    await expect(input).toHaveAccessibleName(/1 connected/);
    await page.keyboard.press('Control+z');
    await expect(input).toHaveAccessibleName(/not connected/);
  });

  await test.step('a tap on each end makes a wire', async () => {
    await pen.tap(await graph.middleOf(output));
    await expect(page.getByText(/the target/)).toBeVisible();
    await pen.tap(await graph.middleOf(input));
    await expect(input).toHaveAccessibleName(/1 connected/);
  });

  await test.step('on nothing it moves the canvas', async () => {
    const before = await place();
    const spot = await graph.spot(0.5, 0.7);
    await pen.drag(spot, { x: spot.x - 70, y: spot.y - 40 });
    await expect.poll(async () => (await place()).x - before.x).toBeCloseTo(-70, -1);
  });

  await test.step('held still it asks for the menu, and chooses in it', async () => {
    await pen.hold(await graph.grip('Module sink'), () => expect(graph.menu).toBeVisible());
    await expect(graph.menu).toBeVisible();
    await pen.tap(await graph.middleOf(graph.menuItem('Bypass')));
    await expect(sink).toContainText('bypassed');
    await expect(graph.menu).toBeHidden();
  });

  await test.step('something from the palette is dragged in', async () => {
    const row = graph.paletteModule('low-pass');
    await row.scrollIntoViewIfNeeded();
    await pen.drag(await graph.middleOf(row), await graph.spot(0.5, 0.8));
    await expect(graph.node('Module low-pass')).toBeVisible();
  });

  await test.step('a wire that is tapped is selected, and bent by dragging', async () => {
    await page.keyboard.press('Escape');
    const middle = await graph.between(output, input);
    await pen.drag(middle, { x: middle.x, y: middle.y + 90 });
    await expect(graph.points).toHaveCount(1);
  });
});
