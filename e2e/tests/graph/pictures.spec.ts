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

test('pictures with what was found in them are on nodes, and where the pointer rests', async ({
  room,
  master,
}) => {
  const camera = await room.program('camera');
  const timer = setInterval(() => {
    camera.publish('/kitchen/image', 'image2D', PICTURE);
    camera.publish('/kitchen/objects', 'object2DList', { elements: [CUP] });
    camera.publish('/other/objects', 'object2DList', { elements: [CUP] });
  }, 100);
  const { sessionList } = await callService(master.endpoints, {
    topic: SERVICES.sessionDatabaseSave.topic,
    session: SESSION,
  });
  const graph = new GraphPage(await room.atDesk('Anna'));
  await graph.open(sessionList!.elements[0]!.id);
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
