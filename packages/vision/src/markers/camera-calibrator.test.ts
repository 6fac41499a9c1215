import { beforeAll, describe, expect, it } from 'vitest';
import { BOARD_POSES, boardImage } from '../../test/marker-images.ts';
import { renderScene } from '../../test/marker-scene.ts';
import { createOpenCvRuntime } from '../../test/open-cv-set.ts';
import type { OpenCvRuntime } from '../opencv/open-cv-runtime.ts';
import { CameraCalibrator, type CalibrationLook } from './camera-calibrator.ts';
import { WANTED_VIEWS } from './calibration-views.ts';
import type { CameraCalibration } from './camera-calibration.ts';
import { DEFAULT_BOARD } from './charuco-board.ts';

/** A webcam with a visible lens. */
const CAMERA: CameraCalibration = {
  width: 640,
  height: 480,
  fx: 600,
  fy: 604,
  cx: 331,
  cy: 228,
  distortion: [0.12, -0.2, 0.001, -0.002, 0],
};

let runtime: OpenCvRuntime;
beforeAll(() => {
  runtime = createOpenCvRuntime();
});

const picture = (pose: (typeof BOARD_POSES)[number]) => boardImage(CAMERA, pose);

describe('CameraCalibrator', () => {
  it('finds focal lengths within 1 %, and the lens, from views that differ', async () => {
    const calibrator = new CameraCalibrator(runtime, DEFAULT_BOARD);
    let look: CalibrationLook | undefined;
    for (const pose of BOARD_POSES) {
      const seen = picture(pose);
      await calibrator.look(seen);
      look = await calibrator.look(seen);
      if (look.calibration) break;
    }
    const found = look!.calibration!;
    expect(look!.views).toBe(WANTED_VIEWS);
    expect(Math.abs(found.fx / CAMERA.fx - 1)).toBeLessThan(0.01);
    expect(Math.abs(found.fy / CAMERA.fy - 1)).toBeLessThan(0.01);
    expect(Math.abs(found.cx - CAMERA.cx)).toBeLessThan(6);
    expect(Math.abs(found.cy - CAMERA.cy)).toBeLessThan(6);
    expect(found.distortion[0]).toBeCloseTo(CAMERA.distortion[0]!, 1);
    expect(found.reprojectionErrorPx).toBeLessThan(0.5);
    expect(look!.hint).toBe('The camera is calibrated.');
    calibrator.dispose();
  }, 120_000);

  it('takes a view only of a board that is still and elsewhere, and says what to do', async () => {
    const calibrator = new CameraCalibrator(runtime, DEFAULT_BOARD);
    const empty = renderScene(CAMERA, []);
    expect(await calibrator.look(empty)).toMatchObject({
      corners: [],
      views: 0,
      hint: 'Show the board to the camera.',
    });
    const straight = picture(BOARD_POSES[0]!);
    expect(await calibrator.look(straight)).toMatchObject({
      isTaken: false,
      hint: 'Hold the board still.',
    });
    const taken = await calibrator.look(straight);
    expect(taken).toMatchObject({ isTaken: true, views: 1 });
    expect(taken.corners).toHaveLength(4 * 6);
    expect(taken.hint).toBe('Turn the left side of the board away from the camera.');
    expect(await calibrator.look(straight)).toMatchObject({ isTaken: false, views: 1 });

    const leftAway = picture(BOARD_POSES[1]!);
    await calibrator.look(leftAway);
    expect((await calibrator.look(leftAway)).hint).toBe(
      'Turn the right side of the board away from the camera.',
    );
    calibrator.reset();
    expect((await calibrator.look(empty)).views).toBe(0);
    calibrator.dispose();
  }, 60_000);

  it('begins again when the size of the pictures changes', async () => {
    const calibrator = new CameraCalibrator(runtime, DEFAULT_BOARD);
    const straight = picture(BOARD_POSES[0]!);
    await calibrator.look(straight);
    expect((await calibrator.look(straight)).views).toBe(1);
    expect((await calibrator.look(renderScene({ ...CAMERA, height: 360 }, []))).views).toBe(0);
    calibrator.dispose();
  }, 60_000);

  it('refuses boards that cannot be', () => {
    expect(() => new CameraCalibrator(runtime, { ...DEFAULT_BOARD, columns: 2 })).toThrow(
      '3 to 16',
    );
    const tooLarge = { ...DEFAULT_BOARD, columns: 16, rows: 16 };
    expect(() => new CameraCalibrator(runtime, tooLarge)).toThrow('needs 128 markers');
    const sameSize = { ...DEFAULT_BOARD, markerMetres: DEFAULT_BOARD.squareMetres };
    expect(() => new CameraCalibrator(runtime, sameSize)).toThrow('smaller than its squares');
  });
});
