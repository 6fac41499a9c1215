import type { TopicRecord } from '@ubii/proto';
import { expect, test } from '../../fixtures/test.ts';
import { PublishPage } from '../../pages/publish-page.ts';
import { Shell } from '../../pages/shell.ts';

test('a camera that is not allowed is explained, and one that is gives a picture', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  const got: TopicRecord[] = [];
  await robot.subscribe('/lab/photo').onRecord((record) => got.push(record)).ready;
  const publish = new PublishPage(await room.atDesk());
  // A camera of this machine would show anything: refused first, then a picture that is drawn.
  await publish.page.addInitScript(() => {
    let asked = 0;
    navigator.mediaDevices.getUserMedia = async () => {
      asked += 1;
      if (asked === 1) throw new DOMException('Permission denied', 'NotAllowedError');
      const canvas = document.createElement('canvas');
      canvas.width = 64;
      canvas.height = 48;
      const context = canvas.getContext('2d')!;
      setInterval(() => context.fillRect(0, 0, 64, 48), 50);
      return canvas.captureStream();
    };
  });
  await publish.open();
  await new Shell(publish.page).expectConnected();
  await publish.topic.fill('/lab/photo');
  await publish.choose('image2D');
  const camera = publish.page.getByRole('button', { name: 'From the camera' });
  await camera.click();
  await expect(publish.form.getByRole('alert')).toContainText('Camera access was denied.');
  await camera.click();
  const take = publish.page.getByRole('button', { name: 'Take picture' });
  const shown = publish.page.getByAltText('The picture that is published');
  await expect(async () => {
    if (await take.isVisible()) await take.click();
    await expect(shown).toBeVisible({ timeout: 1000 });
  }).toPass();
  await publish.publish();
  await expect.poll(() => got.at(-1)?.value).toMatchObject({ width: 64, height: 48 });
});
