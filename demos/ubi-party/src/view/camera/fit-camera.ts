/** A point of the world. */
export interface Point3 {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** A part of the canvas, shares of its width and height from the top left. */
export interface FrameRect {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** Optics and orientation of a camera, without its position. */
export interface Lens {
  /** Vertical field of view, degrees. */
  readonly fovDeg: number;
  /** Downward pitch, degrees. */
  readonly pitchDeg: number;
  /** Turned to the left, seen from above, degrees. */
  readonly yawDeg: number;
  /** Width by height of the canvas. */
  readonly aspect: number;
}

/** Position of a camera: it looks at `target`, which the lens shifts on the picture. */
export interface CameraPlace {
  readonly target: Point3;
  readonly distance: number;
  /** In halves of the picture, to the right and up. */
  readonly shiftX: number;
  readonly shiftY: number;
}

interface Box {
  minX: number;
  maxX: number;
  minY: number;
  maxY: number;
}

const SEARCHES = 30;

/** The nearest place from which all points lie in a part of the picture, in the middle of that part. */
export function fitCamera(points: readonly Point3[], lens: Lens, rect: FrameRect): CameraPlace {
  const target = middleOf(points);
  let [near, far] = [1, 400];
  for (let search = 0; search < SEARCHES; search += 1) {
    const distance = (near + far) / 2;
    const box = boxOf(points, target, distance, lens);
    const fits =
      box !== undefined &&
      box.maxX - box.minX <= 2 * (rect.right - rect.left) &&
      box.maxY - box.minY <= 2 * (rect.bottom - rect.top);
    if (fits) far = distance;
    else near = distance;
  }
  const box = boxOf(points, target, far, lens)!;
  return {
    target,
    distance: far,
    shiftX: rect.left + rect.right - 1 - (box.minX + box.maxX) / 2,
    shiftY: 1 - rect.top - rect.bottom - (box.minY + box.maxY) / 2,
  };
}

function middleOf(points: readonly Point3[]): Point3 {
  const middle = (axis: 'x' | 'y' | 'z'): number => {
    const values = points.map((point) => point[axis]);
    return (Math.min(...values) + Math.max(...values)) / 2;
  };
  return { x: middle('x'), y: middle('y'), z: middle('z') };
}

/**
 * Bounding box of the projected points, in halves of the picture from its middle; undefined when one is behind the
 * camera.
 */
function boxOf(
  points: readonly Point3[],
  target: Point3,
  distance: number,
  { fovDeg, pitchDeg, yawDeg, aspect }: Lens,
): Box | undefined {
  const [pitch, yaw] = [(pitchDeg * Math.PI) / 180, (yawDeg * Math.PI) / 180];
  const [sinP, cosP, sinY, cosY] = [Math.sin(pitch), Math.cos(pitch), Math.sin(yaw), Math.cos(yaw)];
  const scale = 1 / Math.tan((fovDeg * Math.PI) / 360);
  const box: Box = { minX: Infinity, maxX: -Infinity, minY: Infinity, maxY: -Infinity };
  for (const point of points) {
    const [dx, y, dz] = [point.x - target.x, point.y - target.y, point.z - target.z];
    const x = dx * cosY - dz * sinY;
    const towards = dx * sinY + dz * cosY;
    const depth = distance - (towards * cosP + y * sinP);
    if (depth < 0.1) return undefined;
    const [px, py] = [(x * scale) / aspect / depth, ((y * cosP - towards * sinP) * scale) / depth];
    box.minX = Math.min(box.minX, px);
    box.maxX = Math.max(box.maxX, px);
    box.minY = Math.min(box.minY, py);
    box.maxY = Math.max(box.maxY, py);
  }
  return box;
}
