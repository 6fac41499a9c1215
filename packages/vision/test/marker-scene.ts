import { CHANNELS, type Picture, type PixelFormat } from '../src/picture.ts';
import type { CameraCalibration } from '../src/markers/camera-calibration.ts';
import { type QuaternionValue, rotate, type Vector3Value } from '../src/markers/rotations.ts';

/** A flat print in a scene: brightness 0 to 1 by place, metres from its centre, x right, y up; undefined beside it. */
export interface Print {
  readonly position: Vector3Value;
  readonly orientation: QuaternionValue;
  readonly brightness: (x: number, y: number) => number | undefined;
}

export interface SceneOptions {
  readonly format?: PixelFormat;
  /** Standard deviation of the noise, of 255. */
  readonly noise?: number;
  /** Blur over so many pixels to each side. */
  readonly blur?: number;
  /** Of what is behind the prints, 0 to 1. */
  readonly background?: number;
  /** Samples of a pixel in each direction. */
  readonly samples?: number;
}

/**
 * A picture of prints as a camera sees them: a ray through each part of a pixel meets the planes of the
 * prints. The frames are those of `MarkerPose`. The first print that is met wins.
 */
export function renderScene(
  camera: CameraCalibration,
  prints: readonly Print[],
  { format = 'GRAY8', noise = 0, blur = 0, background = 0.45, samples = 2 }: SceneOptions = {},
): Picture {
  const { width, height } = camera;
  const planes = prints.map(({ position, orientation, brightness }) => {
    const axis = (x: number, y: number, z: number) => rotate(orientation, { x, y, z });
    const [across, up, normal] = [axis(1, 0, 0), axis(0, 1, 0), axis(0, 0, 1)];
    return { position, brightness, across, up, normal, offset: dot(position, normal) };
  });
  const seen = (rayX: number, rayY: number): number => {
    for (const { position, brightness, across, up, normal, offset } of planes) {
      const along = rayX * normal.x + rayY * normal.y - normal.z;
      if (Math.abs(along) < 1e-9) continue;
      const distance = offset / along;
      if (distance <= 0) continue;
      const x = rayX * distance - position.x;
      const y = rayY * distance - position.y;
      const z = -distance - position.z;
      const value = brightness(
        x * across.x + y * across.y + z * across.z,
        x * up.x + y * up.y + z * up.z,
      );
      if (value !== undefined) return value;
    }
    return background;
  };
  const rays = raysOf(camera, samples);
  const light = new Float64Array(width * height);
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      let sum = 0;
      const first = (row * width + column) * samples ** 2;
      for (let ray = first; ray < first + samples ** 2; ray++) {
        sum += seen(rays[ray * 2]!, rays[ray * 2 + 1]!);
      }
      light[row * width + column] = 20 + (215 * sum) / samples ** 2;
    }
  }
  const soft = blur > 0 ? boxBlur(boxBlur(light, width, height, blur), width, height, blur) : light;
  const random = normalNumbers(1);
  const channels = CHANNELS[format];
  const data = new Uint8Array(width * height * channels);
  for (let pixel = 0; pixel < soft.length; pixel++) {
    const value = Math.round(Math.min(255, Math.max(0, soft[pixel]! + noise * random())));
    data.fill(value, pixel * channels, (pixel + 1) * channels);
    if (channels === 4) data[pixel * 4 + 3] = 255;
  }
  return { width, height, format, data };
}

/** Ink of cells within a white margin, as a print: rows from the top, true for black. */
export function cellPrint(
  cells: readonly (readonly boolean[])[],
  cellMetres: number,
  pose: Pick<Print, 'position' | 'orientation'>,
  marginMetres = cellMetres,
): Print {
  const rows = cells.length;
  const columns = cells[0]!.length;
  const [halfWidth, halfHeight] = [(columns * cellMetres) / 2, (rows * cellMetres) / 2];
  return {
    ...pose,
    brightness: (x, y) => {
      if (Math.abs(x) > halfWidth + marginMetres || Math.abs(y) > halfHeight + marginMetres) {
        return undefined;
      }
      const row = Math.floor((halfHeight - y) / cellMetres);
      const column = Math.floor((x + halfWidth) / cellMetres);
      return cells[row]?.[column] === true ? 0 : 1;
    },
  };
}

/** Turns about x, then y, then z of the camera, degrees. */
export function turned(xDegrees: number, yDegrees: number, zDegrees = 0): QuaternionValue {
  const about = (degrees: number, axis: 'x' | 'y' | 'z'): QuaternionValue => {
    const half = (degrees * Math.PI) / 360;
    return { x: 0, y: 0, z: 0, w: Math.cos(half), [axis]: Math.sin(half) };
  };
  const product = (a: QuaternionValue, b: QuaternionValue): QuaternionValue => ({
    x: a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
    y: a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
    z: a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
    w: a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
  });
  return product(about(zDegrees, 'z'), product(about(yDegrees, 'y'), about(xDegrees, 'x')));
}

/** Rays of the cameras of a test file: many scenes have the same camera. */
const known = new WeakMap<CameraCalibration, Map<number, Float64Array>>();

/** Directions of the rays through the parts of each pixel, pixel by pixel: x and y of each, z is -1. */
function raysOf(camera: CameraCalibration, samples: number): Float64Array {
  const ofCamera = known.get(camera) ?? new Map<number, Float64Array>();
  known.set(camera, ofCamera);
  const rays = ofCamera.get(samples) ?? computeRays(camera, samples);
  ofCamera.set(samples, rays);
  return rays;
}

function computeRays(camera: CameraCalibration, samples: number): Float64Array {
  const { width, height } = camera;
  const rays = new Float64Array(width * height * samples ** 2 * 2);
  let next = 0;
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      for (let sub = 0; sub < samples ** 2; sub++) {
        const dx = ((sub % samples) + 0.5) / samples - 0.5;
        const dy = (Math.floor(sub / samples) + 0.5) / samples - 0.5;
        writeRay(rays, next, camera, column + dx, row + dy);
        next += 2;
      }
    }
  }
  return rays;
}

/** The direction of what a pixel sees, in the frame of `MarkerPose`; the lens is undone by iteration, as OpenCV does. */
function writeRay(
  rays: Float64Array,
  index: number,
  camera: CameraCalibration,
  px: number,
  py: number,
): void {
  const [k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0] = camera.distortion;
  const x0 = (px - camera.cx) / camera.fx;
  const y0 = (py - camera.cy) / camera.fy;
  let [x, y] = [x0, y0];
  for (let round = 0; camera.distortion.length > 0 && round < 8; round++) {
    const r2 = x * x + y * y;
    const radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    const dx = 2 * p1 * x * y + p2 * (r2 + 2 * x * x);
    const dy = p1 * (r2 + 2 * y * y) + 2 * p2 * x * y;
    [x, y] = [(x0 - dx) / radial, (y0 - dy) / radial];
  }
  rays[index] = x;
  rays[index + 1] = -y;
}

const dot = (a: Vector3Value, b: Vector3Value): number => a.x * b.x + a.y * b.y + a.z * b.z;

function boxBlur(light: Float64Array, width: number, height: number, reach: number): Float64Array {
  const result = new Float64Array(light.length);
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      let [sum, count] = [0, 0];
      for (let y = Math.max(0, row - reach); y <= Math.min(height - 1, row + reach); y++) {
        for (let x = Math.max(0, column - reach); x <= Math.min(width - 1, column + reach); x++) {
          sum += light[y * width + x]!;
          count++;
        }
      }
      result[row * width + column] = sum / count;
    }
  }
  return result;
}

/** Normally distributed numbers, the same in each run (Marsaglia's xorshift, Box-Muller). */
function normalNumbers(seed: number): () => number {
  let state = seed;
  const uniform = (): number => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return ((state >>> 0) + 1) / (2 ** 32 + 1);
  };
  return () => Math.sqrt(-2 * Math.log(uniform())) * Math.cos(2 * Math.PI * uniform());
}
