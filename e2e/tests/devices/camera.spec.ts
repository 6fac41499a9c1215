import type { Page } from '@playwright/test';
import { Image2DDataFormat, type Image2D } from '@ubii/proto';
import { LAUNCH_WITH_CAMERA } from '../../fixtures/chromium.ts';
import { expect, test, type Person, type Room } from '../../fixtures/test.ts';

test.use({ launchOptions: LAUNCH_WITH_CAMERA });

async function openCamera(room: Room): Promise<Person> {
  const phone = await room.withPhone('Mara', { permissions: ['camera'] });
  await phone.page.goto('/devices/camera');
  return phone;
}

/** Has the browser answer the question for the camera with an error. */
async function failWith(page: Page, name: string): Promise<void> {
  await page.addInitScript((error) => {
    navigator.mediaDevices.getUserMedia = () => Promise.reject(new DOMException('', error));
  }, name);
}

test('a phone sends pictures once it is told to, and shows what is found in them', async ({
  room,
}) => {
  const program = await room.program('detector');
  const pictures = program.subscribe(
    { glob: '/*/CameraWebInterface/camera_image' },
    { format: 'image2D' },
  );
  let newest: { image: Image2D; topic: string } | undefined;
  let count = 0;
  pictures.onRecord(({ value, topic }) => {
    newest = { image: value, topic };
    count += 1;
  });
  await pictures.ready;
  const { page } = await openCamera(room);

  await test.step('it is a device with the names that existing programs look for', async () => {
    const find = async () =>
      (await program.call('deviceGetList', { elements: [{ name: 'CameraWebInterface' }] }))
        .elements;
    await expect.poll(async () => (await find()).length).toBe(1);
    const [device] = await find();
    const prefix = `/${device!.clientId}/CameraWebInterface`;
    expect(device!.components).toMatchObject([
      { topic: `${prefix}/camera_image`, messageFormat: 'ubii.dataStructure.Image2D', ioType: 0 },
      { topic: `${prefix}/objects`, messageFormat: 'ubii.dataStructure.Object2DList', ioType: 1 },
      { topic: `${prefix}/calibration`, messageFormat: 'string', ioType: 0 },
    ]);
    await expect(page.getByText('Start it to publish pictures')).toBeVisible();
    expect(count).toBe(0);
  });

  await test.step('raw pictures of the chosen size come', async () => {
    await page.getByRole('button', { name: 'Start the camera' }).tap();
    await expect.poll(() => newest?.image.width).toBe(320);
    const { image } = newest!;
    expect(image.dataFormat).toBe(Image2DDataFormat.RGB8);
    expect(image.data.length).toBe(image.width * image.height * 3);
    // A picture, and not a black one.
    expect(new Set(image.data).size).toBeGreaterThan(2);
    await page.getByRole('radio', { name: '160' }).tap();
    await expect.poll(() => newest?.image.width).toBe(160);
  });

  await test.step('a JPEG takes fewer bytes, and says its size', async () => {
    await page.getByRole('combobox', { name: 'Format of the pictures' }).tap();
    await page.getByRole('option', { name: /JPEG/ }).tap();
    await expect.poll(() => newest?.image.data[0]).toBe(0xff);
    const { image } = newest!;
    expect(image.width).toBe(160);
    expect(image.data.length).toBeLessThan(image.width * image.height);
    await expect(page.getByRole('slider', { name: 'Quality of the JPEG' })).toBeVisible();
  });

  await test.step('boxes that come back are drawn over the picture', async () => {
    program.publish(newest!.topic.replace('camera_image', 'objects'), 'object2DList', {
      elements: [
        {
          id: 'person',
          pose: { position: { x: 0.25, y: 0.2 } },
          size: { x: 0.5, y: 0.6 },
          userDataJson: '',
        },
      ],
    });
    await expect(page.locator('[data-shape="person"] path').first()).toBeVisible();
    await expect(page.getByText('1 object found.')).toBeVisible();
  });

  await test.step('the camera rests while the page is hidden, and comes back with it', async () => {
    const show = async (state: 'hidden' | 'visible') =>
      page.evaluate((now) => {
        Object.defineProperty(document, 'visibilityState', { value: now, configurable: true });
        document.dispatchEvent(new Event('visibilitychange'));
      }, state);
    await show('hidden');
    await expect(page.getByText('The camera pauses while the page is hidden.')).toBeVisible();
    const before = count;
    await show('visible');
    await expect.poll(() => count).toBeGreaterThan(before + 1);
  });

  await test.step('stopped, it sends nothing', async () => {
    await page.getByRole('button', { name: 'Stop the camera' }).tap();
    await expect(page.getByText('Start it to publish pictures')).toBeVisible();
  });

  await test.step('it is remembered how this camera sends, also when it is gone and another is there', async () => {
    for (const isGone of [false, true]) {
      if (isGone) {
        await page.evaluate(() => {
          const kept = localStorage.getItem('ubii.camera') ?? '';
          const { chosen } = JSON.parse(kept) as { chosen: string };
          localStorage.setItem('ubii.camera', kept.replaceAll(chosen, 'unplugged'));
        });
      }
      await page.reload();
      const before = count;
      await expect(page.getByRole('radio', { name: '160' })).toBeChecked();
      await page.getByRole('button', { name: 'Start the camera' }).tap();
      await expect.poll(() => count).toBeGreaterThan(before);
      expect([newest?.image.width, newest?.image.data[0]]).toEqual([160, 0xff]);
    }
  });
});

test('JPEG pictures are made where the browser can make them', async ({ room }) => {
  const program = await room.program('detector');
  const pictures = program.subscribe(
    { glob: '/*/CameraWebInterface/camera_image' },
    { format: 'image2D' },
  );
  let jpegs = 0;
  pictures.onRecord(({ value }) => (jpegs += value.data[0] === 0xff ? 1 : 0));
  const { context } = await room.withPhone('Mara', { permissions: ['camera'] });
  /** Browsers that encode beside the page, and others: each must not need what the other has. */
  for (const [where, takeAway] of [
    ['in a worker', () => (HTMLCanvasElement.prototype.toBlob = () => undefined)],
    ['in the page', () => Reflect.deleteProperty(globalThis, 'OffscreenCanvas')],
  ] as const) {
    await test.step(`JPEG pictures are made ${where}`, async () => {
      const page = await context.newPage();
      await page.addInitScript(takeAway);
      await page.goto('/devices/camera');
      await page.getByRole('combobox', { name: 'Format of the pictures' }).tap();
      await page.getByRole('option', { name: /JPEG/ }).tap();
      jpegs = 0;
      await page.getByRole('button', { name: 'Start the camera' }).tap();
      await expect.poll(() => jpegs).toBeGreaterThan(3);
      await page.close();
    });
  }
});

test('a camera that answers with an error is told in words, and may be tried again', async ({
  room,
}) => {
  const { context } = await room.withPhone('Mara');
  for (const [name, words] of [
    ['NotAllowedError', 'Camera access was denied.'],
    ['NotFoundError', 'This device has no camera.'],
    ['NotReadableError', 'in use by another program or tab'],
  ] as const) {
    await test.step(`a camera that answers with ${name} is told in words, and may be tried again`, async () => {
      const page = await context.newPage();
      await failWith(page, name);
      await page.goto('/devices/camera');
      await page.getByRole('button', { name: 'Start the camera' }).tap();
      await expect(page.getByRole('alert').filter({ hasText: words })).toBeVisible();
      await page.evaluate(() => {
        navigator.mediaDevices.getUserMedia = MediaDevices.prototype.getUserMedia;
      });
      await page.getByRole('button', { name: 'Start the camera' }).tap();
      await expect(page.getByRole('button', { name: 'Stop the camera' })).toBeVisible();
      await page.close();
    });
  }
});
