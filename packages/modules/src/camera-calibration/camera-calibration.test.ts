import type { Object2DList } from '@ubii/proto';
import { BOARD_POSES, boardImage } from '@ubii/vision/testing/markers';
import { beforeAll, describe, expect, it } from 'vitest';
import type { DrivenModule } from '../../test/drive-module.ts';
import { driveWithVision } from '../../test/vision-assets.ts';
import { cameraCalibration } from './camera-calibration.ts';

const CAMERA = { width: 640, height: 480, fx: 600, fy: 604, cx: 331, cy: 228, distortion: [] };

let module: DrivenModule;
beforeAll(async () => {
  module = await driveWithVision(cameraCalibration);
}, 60_000);

const imageOf = (pose: (typeof BOARD_POSES)[number]) => ({
  width: 640,
  height: 480,
  dataFormat: 0,
  data: new Uint8Array(boardImage(CAMERA, pose).data),
});
const look = async (image: unknown, parameters: object = {}, ...triggers: string[]) =>
  (await module.run(1000, { image, ...parameters }, ['image', ...triggers])) as {
    calibration?: string;
    views?: number;
    hint?: string;
    corners?: Object2DList;
    error?: string;
  };

describe('camera-calibration', () => {
  it('puts out the calibration once, with the last view, and begins again when told', async () => {
    const calibrations: string[] = [];
    let views = 0;
    for (const image of BOARD_POSES.map(imageOf)) {
      for (let round = 0; round < 2; round++) {
        const given = await look(image);
        if (given.calibration !== undefined) calibrations.push(given.calibration);
        views = given.views!;
      }
    }
    expect(calibrations).toHaveLength(1);
    const { fx, views: used, width } = JSON.parse(calibrations[0]!) as Record<string, number>;
    expect(Math.abs(fx! / 600 - 1)).toBeLessThan(0.01);
    expect({ views, used, width }).toEqual({ views: 12, used: 12, width: 640 });

    const again = await look(imageOf(BOARD_POSES[0]!), { startOver: true }, 'startOver');
    expect(again.views).toBe(0);
  }, 120_000);

  it('says what to do, and where the corners are', async () => {
    const straight = imageOf(BOARD_POSES[0]!);
    await look(straight, { startOver: true }, 'startOver');
    const { hint, corners } = await look(straight);
    expect(hint).toBe('Turn the left side of the board away from the camera.');
    expect(corners?.elements).toHaveLength(24);
    expect(JSON.parse(corners!.elements[3]!.userDataJson)).toEqual({ corner: 3 });
  }, 60_000);

  it('says once what is wrong with a board or an image, and goes on', async () => {
    const straight = imageOf(BOARD_POSES[0]!);
    expect((await look(straight, { columns: 1 })).error).toContain('3 to 16');
    expect(await look(straight)).toEqual({});
    expect((await look(straight, { columns: undefined })).error).toBe('');
    const broken = { width: 10, height: 10, dataFormat: 2, data: new Uint8Array(7) };
    expect((await look(broken)).error).toMatch(/7 bytes/);
    expect((await look(straight)).error).toBe('');
  }, 60_000);

  it('looks for another board when the parameters change', async () => {
    const straight = imageOf(BOARD_POSES[0]!);
    const other = { dictionary: 'aruco_6x6_50' };
    expect((await look(straight, other)).corners?.elements).toEqual([]);
    const back = await look(straight, { dictionary: undefined });
    expect(back.corners?.elements).toHaveLength(24);
    expect(back.views).toBe(0);
  }, 60_000);
});
