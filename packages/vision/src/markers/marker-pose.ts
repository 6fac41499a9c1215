import type { CvMat, OpenCv } from '../opencv/open-cv.ts';
import type { Keep } from '../opencv/open-cv-runtime.ts';
import type { CameraCalibration } from './camera-calibration.ts';
import {
  angleBetween,
  axisAngleOfQuaternion,
  multiply,
  quaternionOfAxisAngle,
  type QuaternionValue,
  rotate,
  type Vector3Value,
} from './rotations.ts';

/** A place in a picture, pixels; (0, 0) is the centre of the first pixel. */
export interface PixelPoint {
  readonly x: number;
  readonly y: number;
}

/**
 * Pose of a marker in the frame of the camera: right-handed, origin in the lens, x to the right of the picture, y up, z
 * from the scene to the viewer, so that everything visible has a negative z; metres. The frame of a marker has its
 * origin in the centre, x to the right of the print, y up, z out of the paper.
 */
export interface MarkerPose {
  readonly position: Vector3Value;
  /** Turns the axes of the camera into those of the marker; (0, 0, 0, 1) for a marker seen upright from the front. */
  readonly orientation: QuaternionValue;
  /** Root mean square of the distance between seen and expected corners, pixels. */
  readonly errorPx: number;
}

/** Half a turn about x: from OpenCV's frame (y down, z away) to ours, and back. */
const HALF_TURN: QuaternionValue = { x: 1, y: 0, z: 0, w: 0 };

/** Two solutions closer than this are one, radians. */
const SAME_ANGLE = (2 * Math.PI) / 180;

/** The calibration as matrices of OpenCV. */
export function cameraMats(
  cv: OpenCv,
  keep: Keep,
  { fx, fy, cx, cy, distortion }: CameraCalibration,
): { matrix: CvMat; distortion: CvMat } {
  const matrix = keep(new cv.Mat(3, 3, cv.CV_64FC1));
  matrix.data64F.set([fx, 0, cx, 0, fy, cy, 0, 0, 1]);
  const lens = keep(new cv.Mat(1, 5, cv.CV_64FC1));
  lens.data64F.set(distortion.length === 5 ? distortion : [0, 0, 0, 0, 0]);
  return { matrix, distortion: lens };
}

/**
 * Poses that explain the corners of a square. A small or distant marker looks nearly the same when it is
 * tilted the other way, so there can be two: the one with the lower error first.
 *
 * Sources: Collins and Bartoli, Infinitesimal Plane-Based Pose Estimation (2014), by OpenCV
 * (SOLVEPNP_IPPE_SQUARE), refined by Levenberg-Marquardt; the second starts from the first, mirrored at
 * the line of sight (Schweighofer and Pinz, Robust Pose Estimation from a Planar Target, 2006).
 *
 * @param corners top left, top right, bottom right, bottom left of the print
 * @param sizeMetres side of the marker, its black border included
 */
export function markerPoses(
  cv: OpenCv,
  keep: Keep,
  corners: readonly PixelPoint[],
  sizeMetres: number,
  camera: ReturnType<typeof cameraMats>,
): readonly MarkerPose[] {
  const half = sizeMetres / 2;
  const square = keep(new cv.Mat(4, 1, cv.CV_32FC3));
  square.data32F.set([-half, half, 0, half, half, 0, half, -half, 0, -half, -half, 0]);
  const seen = keep(new cv.Mat(4, 1, cv.CV_32FC2));
  seen.data32F.set(corners.flatMap(({ x, y }) => [x, y]));
  const rotation = keep(new cv.Mat(3, 1, cv.CV_64FC1));
  const translation = keep(new cv.Mat(3, 1, cv.CV_64FC1));
  const { matrix, distortion } = camera;
  const method = cv.SOLVEPNP_IPPE_SQUARE;
  if (!cv.solvePnP(square, seen, matrix, distortion, rotation, translation, false, method)) {
    return [];
  }
  const expected = keep(new cv.Mat());
  const refined = (): { turn: QuaternionValue; at: Vector3Value; errorPx: number } => {
    cv.solvePnPRefineLM(square, seen, matrix, distortion, rotation, translation);
    cv.projectPoints(square, rotation, translation, matrix, distortion, expected);
    const errorPx = rootMeanSquare(corners, expected.data32F);
    const [rx, ry, rz] = rotation.data64F as unknown as [number, number, number];
    const [x, y, z] = translation.data64F as unknown as [number, number, number];
    return { turn: quaternionOfAxisAngle([rx, ry, rz]), at: { x, y, z }, errorPx };
  };
  const first = refined();
  rotation.data64F.set(axisAngleOfQuaternion(mirrored(first.turn, first.at)));
  const second = refined();
  return [first, second]
    .filter(({ at, errorPx }) => at.z > 0 && Number.isFinite(errorPx))
    .filter((one) => one === first || angleBetween(first.turn, one.turn) > SAME_ANGLE)
    .sort((a, b) => a.errorPx - b.errorPx)
    .map(({ turn, at, errorPx }) => ({
      position: { x: at.x, y: -at.y, z: -at.z },
      orientation: orientationOf(turn),
      errorPx,
    }));
}

/** An orientation of OpenCV's frame in ours. */
export function orientationOf(turn: QuaternionValue): QuaternionValue {
  return withPositiveW(multiply(HALF_TURN, turn));
}

/** Projects the centre of a marker and the ends of its axes to the picture, in this order: centre, x, y, z. */
export function projectedAxes(
  cv: OpenCv,
  keep: Keep,
  { position: { x, y, z }, orientation }: MarkerPose,
  lengthMetres: number,
  camera: ReturnType<typeof cameraMats>,
): readonly PixelPoint[] {
  const points = keep(new cv.Mat(4, 1, cv.CV_32FC3));
  const length = lengthMetres;
  points.data32F.set([0, 0, 0, length, 0, 0, 0, length, 0, 0, 0, length]);
  const rotation = keep(new cv.Mat(3, 1, cv.CV_64FC1));
  rotation.data64F.set(axisAngleOfQuaternion(withPositiveW(multiply(HALF_TURN, orientation))));
  const translation = keep(new cv.Mat(3, 1, cv.CV_64FC1));
  translation.data64F.set([x, -y, -z]);
  const projected = keep(new cv.Mat());
  cv.projectPoints(points, rotation, translation, camera.matrix, camera.distortion, projected);
  const places = projected.data32F;
  return [0, 1, 2, 3].map((index) => ({ x: places[2 * index]!, y: places[2 * index + 1]! }));
}

/** The orientation whose normal lies on the other side of the line of sight, in OpenCV's frame. */
function mirrored(turn: QuaternionValue, at: Vector3Value): QuaternionValue {
  const normal = rotate(turn, { x: 0, y: 0, z: 1 });
  const distance = Math.hypot(at.x, at.y, at.z) || 1;
  const sight = { x: -at.x / distance, y: -at.y / distance, z: -at.z / distance };
  // The quaternion from the normal to the line of sight; applied twice, it goes on to the other side
  const half = {
    x: normal.y * sight.z - normal.z * sight.y,
    y: normal.z * sight.x - normal.x * sight.z,
    z: normal.x * sight.y - normal.y * sight.x,
    w: 1 + normal.x * sight.x + normal.y * sight.y + normal.z * sight.z,
  };
  const length = Math.hypot(half.x, half.y, half.z, half.w);
  if (length < 1e-9) return turn;
  const toSight = {
    x: half.x / length,
    y: half.y / length,
    z: half.z / length,
    w: half.w / length,
  };
  return multiply(multiply(toSight, toSight), turn);
}

const withPositiveW = ({ x, y, z, w }: QuaternionValue): QuaternionValue =>
  w < 0 ? { x: -x, y: -y, z: -z, w: -w } : { x, y, z, w };

function rootMeanSquare(seen: readonly PixelPoint[], expected: Float32Array): number {
  const squares = seen.map(
    ({ x, y }, index) => (x - expected[2 * index]!) ** 2 + (y - expected[2 * index + 1]!) ** 2,
  );
  return Math.sqrt(squares.reduce((sum, one) => sum + one, 0) / seen.length);
}
