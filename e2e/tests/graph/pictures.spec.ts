import { Image2DDataFormat, SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

const PICTURE = {
  width: 64,
  height: 48,
  dataFormat: Image2DDataFormat.RGB8,
  data: new Uint8Array(64 * 48 * 3).fill(90),
};
const CUP = {
  id: 'cup',
  pose: { position: { x: 0.5, y: 0.25 } },
  size: { x: 0.25, y: 0.5 },
  userDataJson: '{"score":0.87}',
};
const SESSION = {
  name: 'Kitchen',
  processingModules: [{ id: 'eyes', name: 'object-detection' }],
  ioMappings: [
    {
      processingModuleId: 'eyes',
      inputMappings: [{ inputName: 'image', topic: '/kitchen/image' }],
      outputMappings: [{ outputName: 'predictions', topic: '/kitchen/objects' }],
    },
  ],
};

test('pictures are seen on nodes and where the pointer rests', async ({ room, master }) => {
  const camera = await room.program('camera');
  const graph = new GraphPage(await room.atDesk('Anna'));
  const { sessionList } = await callService(master.endpoints, {
    topic: SERVICES.sessionDatabaseSave.topic,
    session: SESSION,
  });
  await graph.open(sessionList!.elements[0]!.id);
  await test.step('a topic with pictures shows them on its node', async () => {
    const [width, height] = [32, 24];
    const data = new Uint8Array(width * height * 3);
    for (let at = 0; at < data.length; at += 3) data[at] = 200;
    const picture = { width, height, dataFormat: Image2DDataFormat.RGB8, data };
    const timer = setInterval(() => camera.publish('/cam/image', 'image2D', picture), 100);
    await graph.drag(graph.paletteTopic('/cam/image'), await graph.spot(0.75, 0.8));
    const shown = graph.node('Topic /cam/image').getByRole('img', { name: 'The newest picture' });
    await expect(shown).toBeVisible();
    await expect
      .poll(() =>
        shown.evaluate((canvas) => {
          const { width: w, height: h } = canvas as HTMLCanvasElement;
          const context = (canvas as HTMLCanvasElement).getContext('2d')!;
          return [...context.getImageData(w / 2, h / 2, 1, 1).data];
        }),
      )
      .toEqual([200, 0, 0, 255]);
    await expect(graph.inspector.getByRole('img', { name: 'The newest picture' })).toBeVisible();
    clearInterval(timer);
  });

  await test.step('pictures with what was found in them are on nodes, and where the pointer rests', async () => {
    const timer = setInterval(() => {
      camera.publish('/kitchen/image', 'image2D', PICTURE);
      camera.publish('/kitchen/objects', 'object2DList', { elements: [CUP] });
      camera.publish('/other/objects', 'object2DList', { elements: [CUP] });
    }, 100);
    const picture = { name: 'The newest picture' };
    const cup = '[data-shape="cup"]';

    await test.step('on the topic of the picture and on that of the objects', async () => {
      for (const name of ['Topic /kitchen/image', 'Topic /kitchen/objects']) {
        await expect(graph.node(name).getByRole('img', picture)).toBeVisible();
        await expect(graph.node(name).locator(cup)).toBeVisible();
      }
    });

    await test.step('over the picture on the card of a wire, with size, format and age', async () => {
      await graph.socket('Module object-detection', 'Input image').hover();
      await expect(graph.passing.getByRole('img', picture)).toBeVisible();
      await expect(graph.passing.locator('[data-label="cup"]')).toContainText('.87');
      await expect(graph.passing).toContainText(/64 × 48\s+RGB8/);
      await expect(graph.passing).toContainText(/\d+ m?s/);
      await graph.page.mouse.move(5, 5);
      await graph.socket('Module object-detection', 'Output predictions').hover();
      await expect(graph.passing).toContainText('/kitchen/objects');
      await expect(graph.passing.getByRole('img', picture)).toBeVisible();
      await expect(graph.passing.locator(cup)).toBeVisible();
      await graph.page.mouse.move(5, 5);
    });

    await test.step('over an empty pad where no module says which picture it was', async () => {
      await graph.drag(graph.paletteTopic('/other/objects'), await graph.spot(0.3, 0.8));
      const other = graph.node('Topic /other/objects');
      await expect(other.locator(cup)).toBeVisible();
      await expect(other.getByRole('img', picture)).toHaveCount(0);
    });
    clearInterval(timer);
  });
});
