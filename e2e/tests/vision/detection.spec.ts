import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Object2DList } from '@ubii/proto';
import { expect, test } from '../../fixtures/test.ts';
import { SessionPage } from '../../pages/session-page.ts';

const PHOTOS = join(import.meta.dirname, '../../../packages/vision/photos');
const SESSION = {
  name: 'Kitchen watch',
  processingModules: [{ name: 'object-detection' }],
  ioMappings: [
    {
      processingModuleName: 'object-detection',
      inputMappings: [{ inputName: 'image', topic: '/kitchen/image' }],
      outputMappings: [{ outputName: 'predictions', topic: '/kitchen/objects' }],
    },
  ],
};

test('objects in pictures are found on the master and, moved while it runs, in a tab [PM-90] @smoke', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  const anna = await room.atDesk('Anna');
  let newest: { by: string; list: Object2DList } | undefined;
  const subscription = robot.subscribe('/kitchen/objects', { format: 'object2DList' });
  subscription.onRecord(({ value, clientId }) => (newest = { by: clientId, list: value }));
  await subscription.ready;
  let photo = 'coffee.jpg';
  let master = '';
  const publishing = setInterval(() => {
    const data = new Uint8Array(readFileSync(join(PHOTOS, photo)));
    robot.publish('/kitchen/image', 'image2D', { width: 0, height: 0, dataFormat: 0, data });
  }, 500);
  const classes = (): string[] | undefined => newest?.list.elements.map(({ id }) => id);

  try {
    const { id } = await robot.call('sessionRuntimeStart', SESSION);
    const session = new SessionPage(anna);
    await test.step('on the master', async () => {
      await expect.poll(classes).toEqual(['cup']);
      const [cup] = newest!.list.elements;
      master = newest!.by;
      // Measured on the picture by hand.
      expect(cup!.pose?.position?.x).toBeCloseTo(0.285, 1);
      expect(cup!.size?.x).toBeCloseTo(0.4, 1);
      expect(JSON.parse(cup!.userDataJson)).toHaveProperty('score');
    });

    await test.step('in this tab, with models that the master serves', async () => {
      await anna.page.goto(`/sessions/${id}/log`);
      await session.place('object-detection', /^This tab/);
      photo = 'chelsea.jpg';
      await expect.poll(() => newest?.by).not.toBe(master);
      await expect.poll(classes).toEqual(['cat']);
      await expect(session.events).toContainText('Loading the asset set centernet-coco: 100 %');
      await expect(session.events).toContainText('CenterNet uses wasm');
    });

    await test.step('on a Node process, which gets the models from the master, too', async () => {
      const tab = newest!.by;
      await room.node('Workshop');
      await session.place('object-detection', /^Workshop/);
      photo = 'camera.jpg';
      await expect.poll(() => [master, tab].includes(newest!.by)).toBe(false);
      await expect.poll(classes).toEqual(['person']);
    });

    await test.step('as boxes over the picture', async () => {
      await anna.page.goto(`/topics/${encodeURIComponent('/kitchen/image')}`);
      await anna.page.getByRole('button', { name: /^Add overlay/ }).click();
      await anna.page.getByRole('checkbox', { name: /objects/ }).check();
      await anna.page.keyboard.press('Escape');
      await expect(anna.page.getByRole('main')).toContainText('person');
    });
  } finally {
    clearInterval(publishing);
  }
});
