import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

test('somebody drags a topic onto an input, is told what does not fit, starts it and sees the value @smoke', async ({
  room,
  master,
}) => {
  const wave = await room.program('wave');
  const timer = setInterval(() => {
    wave.publish('/wave/height', 'double', 4);
    wave.publish('/wave/name', 'string', 'tide');
  }, 50);
  const { session } = await callService(master.endpoints, {
    topic: '/services/session/runtime/add',
    session: { name: 'Tide' },
  });
  const anna = await room.atDesk('Anna');
  const graph = new GraphPage(anna);
  await graph.open(session!.id);
  const lowPass = graph.node('Module low-pass');

  await test.step('a module comes from the palette', async () => {
    await graph.drag(graph.paletteModule('low-pass'), await graph.spot(0.5, 0.4));
    await expect(lowPass).toBeVisible();
  });

  await test.step('a topic dropped on an input is wired to it', async () => {
    await graph.dragTo(
      graph.paletteTopic('/wave/height'),
      graph.socket('Module low-pass', 'Input value'),
    );
    await expect(graph.node('Topic /wave/height')).toBeVisible();
    await expect(graph.socket('Module low-pass', 'Input value')).toHaveAccessibleName(
      /1 connected/,
    );
  });

  await test.step('a wire that does not fit is refused, and says why', async () => {
    await graph.drag(graph.paletteTopic('/wave/name'), await graph.spot(0.15, 0.75));
    await graph.dragTo(
      graph.socket('Topic /wave/name', 'Output /wave/name'),
      graph.socket('Module low-pass', 'Input cutoffHz'),
    );
    await expect(graph.refusal).toContainText('outputs string');
    await expect(graph.refusal).toContainText('expects double');
    await graph.refusal.getByRole('button', { name: 'Cancel' }).click();
    await expect(graph.refusal).toBeHidden();
    await expect(graph.socket('Module low-pass', 'Input cutoffHz')).toHaveAccessibleName(
      /not connected/,
    );
  });

  await test.step('a wire dropped on nothing offers what fits', async () => {
    await graph.drag(
      graph.socket('Module low-pass', 'Output smoothed'),
      await graph.spot(0.75, 0.3),
    );
    const search = anna.page.getByRole('combobox', { name: 'Connect to a new node' });
    await search.fill('/wave/smooth');
    await search.press('Enter');
    await expect(graph.node('Topic /wave/smooth')).toBeVisible();
  });

  await test.step('what was done is undone and done again by keys', async () => {
    await anna.page.keyboard.press('Control+z');
    await expect(graph.node('Topic /wave/smooth')).toBeHidden();
    await anna.page.keyboard.press('Control+y');
    await expect(graph.node('Topic /wave/smooth')).toBeVisible();
  });

  await test.step('started, its values are seen, here and by others', async () => {
    await graph.life.getByRole('button', { name: 'Start' }).click();
    await expect(graph.life).toContainText('Running');
    await expect(graph.node('Topic /wave/smooth')).toContainText('4.00');
    const ben = await room.atDesk('Ben');
    const other = new GraphPage(ben);
    await other.open(session!.id);
    await expect(other.node('Topic /wave/smooth')).toContainText('4.00');
  });
  clearInterval(timer);
});
