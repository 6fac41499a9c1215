/**
 * Projection of a camera: a pinhole camera with the lens model of OpenCV. Pixel (0, 0) is the centre of the first
 * pixel, x to the right, y down.
 */
export interface CameraCalibration {
  /** Pixels of the pictures it was made from. */
  readonly width: number;
  readonly height: number;
  /** Focal lengths, pixels. */
  readonly fx: number;
  readonly fy: number;
  /** Intersection of the optical axis with the picture, pixels. */
  readonly cx: number;
  readonly cy: number;
  /** k1, k2, p1, p2, k3 of OpenCV; empty for none. */
  readonly distortion: readonly number[];
  /** Root mean square of the distance between where corners were seen and where they are expected, pixels. */
  readonly reprojectionErrorPx?: number;
  /** Pictures it was made from. */
  readonly views?: number;
}

/** Assumed of the longer side of pictures when nothing else is known, degrees: common for webcams and phones. */
export const ASSUMED_FIELD_OF_VIEW_DEGREES = 60;

/** Pictures may differ by this much in the ratio of their sides and still be of the same part of the sensor. */
const MAX_RATIO_DIFFERENCE = 0.02;

/** A calibration of a camera without distortion, by the angle that the longer side of a picture shows. */
export function assumedCalibration(
  width: number,
  height: number,
  fieldOfViewDegrees = ASSUMED_FIELD_OF_VIEW_DEGREES,
): CameraCalibration {
  const focal = Math.max(width, height) / 2 / Math.tan((fieldOfViewDegrees * Math.PI) / 360);
  return {
    width,
    height,
    fx: focal,
    fy: focal,
    cx: (width - 1) / 2,
    cy: (height - 1) / 2,
    distortion: [],
  };
}

/**
 * A calibration for pictures of another resolution.
 *
 * @throws RangeError when the sides have another ratio: cameras crop then, at an unknown place
 */
export function calibrationFor(
  calibration: CameraCalibration,
  width: number,
  height: number,
): CameraCalibration {
  const scaleX = width / calibration.width;
  const scaleY = height / calibration.height;
  if (Math.abs(scaleX / scaleY - 1) > MAX_RATIO_DIFFERENCE) {
    throw new RangeError(
      `The calibration is for pictures of ${calibration.width} × ${calibration.height} pixels, and this one has ${width} × ${height}. Use the same ratio of the sides, or calibrate again.`,
    );
  }
  return {
    ...calibration,
    width,
    height,
    fx: calibration.fx * scaleX,
    fy: calibration.fy * scaleY,
    // Pixel centres: the edge of the picture is at -0.5
    cx: (calibration.cx + 0.5) * scaleX - 0.5,
    cy: (calibration.cy + 0.5) * scaleY - 0.5,
  };
}

const NUMBERS = ['width', 'height', 'fx', 'fy', 'cx', 'cy'] as const;

/**
 * Reads a calibration from JSON text.
 *
 * @throws RangeError that says what is wrong
 */
export function parseCalibration(json: string): CameraCalibration {
  let value: unknown;
  try {
    value = JSON.parse(json);
  } catch {
    throw new RangeError('The calibration is not JSON.');
  }
  const read = (value ?? {}) as Partial<Record<keyof CameraCalibration, unknown>>;
  for (const name of NUMBERS) {
    if (!Number.isFinite(read[name])) {
      throw new RangeError(`The calibration has no number "${name}".`);
    }
  }
  const { width, height, fx, fy, cx, cy } = read as CameraCalibration;
  if (!(width > 0 && height > 0 && fx > 0 && fy > 0)) {
    throw new RangeError('"width", "height", "fx" and "fy" of a calibration are above 0.');
  }
  const distortion = read.distortion ?? [];
  if (
    !Array.isArray(distortion) ||
    !(distortion.length === 0 || distortion.length === 5) ||
    !distortion.every((one) => Number.isFinite(one))
  ) {
    throw new RangeError('"distortion" of a calibration has 5 numbers: k1, k2, p1, p2, k3.');
  }
  const { reprojectionErrorPx, views } = read;
  return {
    width,
    height,
    fx,
    fy,
    cx,
    cy,
    distortion: distortion as number[],
    ...(typeof reprojectionErrorPx === 'number' && { reprojectionErrorPx }),
    ...(typeof views === 'number' && { views }),
  };
}
