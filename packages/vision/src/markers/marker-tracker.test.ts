import { encode } from 'jpeg-js';
import { beforeAll, describe, expect, it } from 'vitest';
import { cellPrint, type Print, renderScene, turned } from '../../test/marker-scene.ts';
import { createOpenCvRuntime } from '../../test/open-cv-set.ts';
import { readImage2D } from '../decoding/decode-picture.ts';
import { convertPicture } from '../image-tools/convert-picture.ts';
import type { OpenCv } from '../opencv/open-cv.ts';
import { OpenCvError, type OpenCvRuntime } from '../opencv/open-cv-runtime.ts';
import { assumedCalibration, type CameraCalibration } from './camera-calibration.ts';
import { MARKER_DICTIONARIES, markerDictionary, markerCells } from './dictionaries.ts';
import { MarkerTracker, type TrackedMarker } from './marker-tracker.ts';
import { angleBetween, type Vector3Value } from './rotations.ts';

/** A webcam with a visible lens. */
const CAMERA: CameraCalibration = {
  width: 640,
  height: 480,
  fx: 560,
  fy: 560,
  cx: 324,
  cy: 236,
  distortion: [0.08, -0.12, 0.001, -0.001, 0],
};
const SIZE = 0.08;
const DEGREE = Math.PI / 180;

/** Largest error of a position, as a part of the distance, and of an angle. */
const POSITION_TOLERANCE = 0.01;
const ANGLE_TOLERANCE = 2 * DEGREE;

let runtime: OpenCvRuntime;
let tracker: MarkerTracker;
beforeAll(() => {
  runtime = createOpenCvRuntime();
  tracker = new MarkerTracker(runtime);
});

const print = (id: number, pose: Omit<Print, 'brightness'>, dictionary = 'aruco_4x4_50'): Print => {
  const cells = markerCells(markerDictionary(dictionary), id);
  return cellPrint(cells, SIZE / cells.length, pose);
};
const at = (x: number, y: number, z: number, orientation = turned(0, 0)) => ({
  position: { x, y, z },
  orientation,
});
const options = { calibration: CAMERA, sizeMetres: SIZE };

function expectPose(found: TrackedMarker | undefined, truth: Omit<Print, 'brightness'>): void {
  const { position, orientation } = found!;
  const off = ({ x, y, z }: Vector3Value): number =>
    Math.hypot(x - truth.position.x, y - truth.position.y, z - truth.position.z);
  const distance = Math.hypot(truth.position.x, truth.position.y, truth.position.z);
  expect(off(position) / distance).toBeLessThan(POSITION_TOLERANCE);
  expect(angleBetween(orientation, truth.orientation)).toBeLessThan(ANGLE_TOLERANCE);
}

describe('poses of markers in generated scenes', () => {
  it.each([
    ['upright from the front', at(0, 0, -0.5)],
    ['to the right and above', at(0.12, 0.09, -0.6, turned(20, -25))],
    ['turned in the plane', at(-0.1, 0.02, -0.45, turned(0, 30, 75))],
    ['tilted by 50 degrees', at(0.05, -0.06, -0.5, turned(50, 10))],
    ['upside down', at(0, 0.05, -0.4, turned(15, 20, 180))],
    ['50 pixels wide', at(-0.2, 0.1, -0.85, turned(-35, 20))],
  ])('are within the tolerance: %s', async (_name, pose) => {
    const [found] = await tracker.track(renderScene(CAMERA, [print(7, pose)]), options);
    expect(found?.name).toBe('aruco_4x4_50:7');
    expectPose(found, pose);
  });

  it('has the identity for a marker that is upright and seen from the front', async () => {
    const centred = { ...CAMERA, cx: 319.5, cy: 239.5, distortion: [] };
    const scene = renderScene(centred, [print(3, at(0, 0, -0.4))]);
    const [found] = await tracker.track(scene, { ...options, calibration: centred });
    expect(found!.orientation.w).toBeGreaterThan(0.999);
    expect(found!.position.z).toBeCloseTo(-0.4, 2);
    const [topLeft, topRight, , bottomLeft] = found!.corners;
    expect(topLeft!.x).toBeLessThan(topRight!.x);
    expect(topLeft!.y).toBeLessThan(bottomLeft!.y);
    const [centre, x, y] = found!.axes;
    expect(x!.x).toBeGreaterThan(centre!.x + 0.02);
    expect(y!.y).toBeLessThan(centre!.y - 0.02);
  });

  it('finds several markers, ordered by id, and only those asked for', async () => {
    const poses = [
      [11, at(-0.15, 0.08, -0.6, turned(20, 25))],
      [2, at(0.12, 0.08, -0.55, turned(-25, 15))],
      [30, at(0, -0.1, -0.5, turned(30, -20, 10))],
    ] as const;
    const scene = renderScene(
      CAMERA,
      poses.map(([id, pose]) => print(id, pose)),
      { noise: 6, blur: 1 },
    );
    const found = await tracker.track(scene, options);
    expect(found.map(({ id }) => id)).toEqual([2, 11, 30]);
    for (const [id, pose] of poses)
      expectPose(
        found.find((one) => one.id === id),
        pose,
      );
    const asked = await tracker.track(scene, { ...options, ids: [30] });
    expect(asked.map(({ id }) => id)).toEqual([30]);
  });

  it('leaves out a marker with a covered corner, and finds the other', async () => {
    const hidden = at(-0.12, 0, -0.5);
    const cover: Print = {
      ...at(-0.15, 0.03, -0.49),
      brightness: (x, y) => (Math.hypot(x, y) < 0.03 ? 0.6 : undefined),
    };
    const scene = renderScene(CAMERA, [cover, print(5, hidden), print(6, at(0.1, 0, -0.5))]);
    expect((await tracker.track(scene, options)).map(({ id }) => id)).toEqual([6]);
  });

  it('finds nothing with another dictionary', async () => {
    const scene = renderScene(CAMERA, [print(7, at(0, 0, -0.5))]);
    expect(await tracker.track(scene, { ...options, dictionary: 'apriltag_36h11' })).toEqual([]);
    expect(await tracker.track(scene, { ...options, dictionary: 'aruco_6x6_250' })).toEqual([]);
  });

  it('takes GRAY8, RGB8 and RGBA8 pixels and JPEG files alike', async () => {
    const pose = at(0.05, 0.02, -0.5, turned(20, 30));
    const grey = renderScene(CAMERA, [print(9, pose)], { noise: 4 });
    const rgba = convertPicture(grey, 'RGBA8');
    const jpeg = encode({ width: 640, height: 480, data: rgba.data }, 80).data;
    const decoded = await readImage2D({ data: new Uint8Array(jpeg) });
    for (const picture of [grey, convertPicture(grey, 'RGB8'), rgba, decoded]) {
      expectPose((await tracker.track(picture, options))[0], pose);
    }
  });

  it('scales a calibration to pictures of another resolution, and down to what is looked at', async () => {
    const large = {
      ...CAMERA,
      width: 2560,
      height: 1920,
      fx: 2240,
      fy: 2240,
      cx: 1297.5,
      cy: 945.5,
    };
    const pose = at(0.04, 0.05, -0.5, turned(25, 20));
    const scene = renderScene(large, [print(1, pose)], { samples: 1 });
    expectPose((await tracker.track(scene, options))[0], pose);
  }, 120_000);

  it('smooths over time when asked to', async () => {
    const fresh = new MarkerTracker(runtime);
    const near = renderScene(CAMERA, [print(4, at(0, 0, -0.5))]);
    const moved = renderScene(CAMERA, [print(4, at(0.1, 0, -0.5))]);
    const smooth = { ...options, smoothingMs: 100, sinceMs: 100 };
    await fresh.track(near, smooth);
    const [found] = await fresh.track(moved, smooth);
    expect(found!.position.x).toBeCloseTo(0.1 * (1 - Math.exp(-1)), 2);
    const [unsmoothed] = await fresh.track(near, { ...options, sinceMs: 100 });
    expect(unsmoothed!.position.x).toBeCloseTo(0, 2);
    fresh.dispose();
  });
});

describe('drawings of markers', () => {
  it.each(MARKER_DICTIONARIES)('are found by OpenCV as $name', async (dictionary) => {
    const ids = [0, 1, Math.floor(dictionary.count / 2), dictionary.count - 1];
    const scene = renderScene(
      CAMERA,
      ids.map((id, index) =>
        print(
          id,
          at(((index % 2) - 0.5) * 0.2, (Math.floor(index / 2) - 0.5) * 0.18, -0.5),
          dictionary.name,
        ),
      ),
    );
    const found = await tracker.track(scene, { ...options, dictionary: dictionary.name });
    expect(found.map(({ id }) => id)).toEqual(ids);
  });

  it('are refused for ids that a dictionary has not', () => {
    expect(() => markerCells(markerDictionary('aruco_4x4_50'), 50)).toThrow('0 to 49');
    expect(() => markerDictionary('aruco_9x9')).toThrow('aruco_4x4_50');
  });
});

describe('MarkerTracker', () => {
  it('does not grow the memory of OpenCV over 500 pictures', async () => {
    const calibration = assumedCalibration(320, 240);
    const scene = renderScene(calibration, [
      print(1, at(-0.06, 0.03, -0.3)),
      print(2, at(0.08, 0.03, -0.4)),
    ]);
    const used = () =>
      runtime.run((cv) => {
        const { _malloc, _free, HEAP8 } = cv as OpenCv & {
          _malloc(bytes: number): number;
          _free(address: number): void;
          HEAP8: Int8Array;
        };
        // A block that fits only where nothing was left behind
        const address = _malloc(8 * 2 ** 20);
        _free(address);
        return { address, bytes: HEAP8.length };
      });
    expect(await tracker.track(scene, { ...options, calibration })).toHaveLength(2);
    const before = await used();
    for (let round = 0; round < 500; round++) {
      await tracker.track(scene, { ...options, calibration });
    }
    expect(await used()).toEqual(before);
  }, 120_000);

  it('says what is wrong with its options', async () => {
    const scene = renderScene(CAMERA, []);
    await expect(tracker.track(scene, { dictionary: 'mine' })).rejects.toThrow(RangeError);
    await expect(tracker.track(scene, { ids: [50] })).rejects.toThrow('no marker 50');
    await expect(tracker.track(scene, { sizeMetres: 0 })).rejects.toThrow('size of a marker');
    const wide = { ...CAMERA, width: 1280, height: 720 };
    await expect(tracker.track(scene, { calibration: wide })).rejects.toThrow('1280 × 720');
  });

  it('continues with another OpenCV after one that stopped', async () => {
    const own = createOpenCvRuntime();
    const fresh = new MarkerTracker(own);
    const scene = renderScene(CAMERA, [print(7, at(0, 0, -0.5))]);
    await fresh.track(scene, options);
    const stopped = own.run((cv, keep) => keep(new cv.Mat(60_000, 60_000, cv.CV_8UC1)));
    await expect(stopped).rejects.toThrow(OpenCvError);
    const refused = own.run((cv, keep) => {
      const empty = keep(new cv.Mat());
      cv.solvePnPRefineLM(empty, empty, empty, empty, empty, empty);
    });
    await expect(refused).rejects.toThrow(/OpenCV refused this/);
    expect(await fresh.track(scene, options)).toHaveLength(1);
    fresh.dispose();
  });
});
