import type { Page } from '@playwright/test';
import { BOARD_POSES, boardImage, jpegFile } from '@ubii/vision/testing/markers';
import { expect, test } from '../../fixtures/test.ts';

const CAMERA = { width: 640, height: 480, fx: 600, fy: 604, cx: 331, cy: 228, distortion: [] };
/** A board is held still for so long, milliseconds. */
const HELD_MS = 500;

/** Gives the page a camera that sees the printed board, held in one way after the other. */
async function showBoard(page: Page): Promise<void> {
  const pictures = BOARD_POSES.map((pose) =>
    Buffer.from(jpegFile(boardImage(CAMERA, pose))).toString('base64'),
  );
  await page.addInitScript(
    ({ pictures, heldMs }) => {
      navigator.mediaDevices.getUserMedia = async () => {
        const canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [640, 480];
        const context = canvas.getContext('2d')!;
        const images = pictures.map((base64) => {
          const image = new Image();
          image.src = `data:image/jpeg;base64,${base64}`;
          return image;
        });
        await Promise.all(images.map((image) => image.decode()));
        let frame = 0;
        setInterval(() => {
          const turn = Math.floor((frame++ * 100) / heldMs);
          context.drawImage(images[turn % images.length]!, 0, 0);
        }, 100);
        const stream = canvas.captureStream();
        const [track] = stream.getVideoTracks();
        track!.getSettings = () => ({ deviceId: 'board-camera', width: 640, height: 480 });
        return stream;
      };
    },
    { pictures, heldMs: HELD_MS },
  );
}

test('a camera is calibrated by the printed board, and sessions get its calibration', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  const anna = await room.atDesk('Anna');
  const { page } = anna;
  await showBoard(page);
  await page.goto('/devices/camera');
  await page.getByRole('link', { name: 'Calibrate this camera' }).click();
  // The camera page has a button of the same name.
  await expect(page.getByRole('heading', { name: 'Calibrate a camera' })).toBeVisible();

  await test.step('views are taken by themselves, and the page says what to do', async () => {
    await page.getByRole('button', { name: 'Start the camera' }).click();
    await expect(page.getByText(/[1-9] of 12 views/)).toBeVisible();
    await expect(page.getByRole('status').filter({ hasText: 'board' })).toBeVisible();
    await expect(page.locator('[data-over$="/corners"]')).toBeAttached();
  });

  await test.step('the result is good, and is kept for this camera', async () => {
    const result = page.getByRole('region', { name: '3. The result' });
    await expect(result).toContainText('Good.', { timeout: 30_000 });
    const focal = await result.getByText(/^\d+ × \d+ px$/).textContent();
    const [fx] = /\d+/.exec(focal!)!;
    expect(Math.abs(Number(fx) / CAMERA.fx - 1)).toBeLessThan(0.03);
    await result.getByRole('button', { name: 'Save for this camera' }).click();
    await expect(result).toContainText('Stored in this browser');
    await page.getByRole('button', { name: 'Start over' }).click();
    await expect(page.getByText(/0 of 12 views/)).toBeVisible();
    await expect(page.getByRole('region', { name: 'Saved for this camera' })).toContainText(
      'Good.',
    );
  });

  await test.step('the camera publishes it', async () => {
    const topics = robot.subscribe(
      { glob: '/*/CameraWebInterface/calibration' },
      { format: 'string' },
    );
    let newest = '';
    topics.onRecord(({ value }) => (newest = value));
    await page.goto('/devices/camera');
    await page.getByRole('button', { name: 'Start the camera' }).click();
    await expect(page.getByText('This camera is calibrated')).toBeVisible();
    await expect.poll(() => newest).toContain('"fx"');
    expect(JSON.parse(newest)).toMatchObject({ width: 640, height: 480, views: 12 });
  });
});
