import type { Object2DList, Object3DList } from '@ubii/proto';
import { HAND_POINTS, handPicture } from '@ubii/vision/hand-picture';
import { beforeAll, describe, expect, it } from 'vitest';
import type { DrivenModule } from '../../test/drive-module.ts';
import { driveWithVision, photoImage } from '../../test/vision-assets.ts';
import { handPose } from './hand-pose.ts';

/** Mean distance of keypoints from where they were drawn, in sides of the hand's square. */
const TOLERANCE = 0.08;
const HAND = { x: 70, y: 50, side: 170 };

let module: DrivenModule;
beforeAll(async () => {
  module = await driveWithVision(handPose);
}, 60_000);

/** One image, later than the rate asks for. */
const detect = async (image: unknown) =>
  (await module.run(1000, { image }, ['image'])) as {
    keypoints?: Object2DList;
    positions?: Object3DList;
    hands?: number;
    error?: string;
  };
function scene() {
  const { width, height, data, format } = handPicture(420, 300, HAND);
  const dataFormat = ['GRAY8', 'RGB8', 'RGBA8'].indexOf(format);
  return { width, height, dataFormat, data: new Uint8Array(data) };
}

describe('hand-pose', () => {
  it('finds the keypoints of a hand where they were drawn, and in metres', async () => {
    const { keypoints, positions, hands } = await detect(scene());
    expect(hands).toBe(1);
    const { elements } = keypoints!;
    expect(elements).toHaveLength(21);
    const [first] = elements;
    expect(first!.id).toMatch(/^(left|right)\.wrist$/);
    expect(JSON.parse(first!.userDataJson)).toMatchObject({ hand: 0 });
    const errors = elements.map(({ pose }, index) => {
      const [x, y] = HAND_POINTS[index]!;
      const { x: foundX = 0, y: foundY = 0 } = pose?.position ?? {};
      const dx = foundX * 420 - HAND.x - x * HAND.side;
      return Math.hypot(dx, foundY * 300 - HAND.y - y * HAND.side) / HAND.side;
    });
    expect(errors.reduce((sum, error) => sum + error, 0) / errors.length).toBeLessThan(TOLERANCE);

    // Metres: hands of adults are 17 to 20 cm long, of which the model takes some for bent.
    const [wrist, tip] = [0, 12].map((index) => positions!.elements[index]!.pose!.position!);
    const length = Math.hypot(wrist!.x - tip!.x, wrist!.y - tip!.y, wrist!.z - tip!.z);
    expect(length).toBeGreaterThan(0.1);
    expect(length).toBeLessThan(0.22);
  });

  it('finds no hand where there is none', async () => {
    expect(await detect(photoImage('chelsea.jpg'))).toMatchObject({
      hands: 0,
      keypoints: { elements: [] },
    });
  });

  it('says once what is wrong with an image, and continues with the next', async () => {
    const broken = { width: 10, height: 10, dataFormat: 2, data: new Uint8Array(7) };
    expect((await detect(broken)).error).toMatch(/7 bytes/);
    expect(await detect(broken)).toEqual({});
    expect(await detect(scene())).toMatchObject({ error: '', hands: 1 });
  });

  it('drops images beyond its rate', async () => {
    await module.run(1000, { image: scene(), maxRate: 2 }, ['image']);
    expect(await module.run(100, {}, ['image'])).toEqual({});
  });
});
