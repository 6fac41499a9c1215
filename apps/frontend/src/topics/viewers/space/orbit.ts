import type { Sphere } from './framing.ts';
import type { Point } from './space-things.ts';

/** Axis that points up on the screen. */
export type Up = 'y' | 'z';

/** Camera position relative to a target. */
export interface Orbit {
  /** Rotation about the up axis, radians; 0 looks along the axis that points to the viewer. */
  readonly azimuth: number;
  /** Angle above the ground, radians, almost from straight down to straight up. */
  readonly elevation: number;
  readonly distance: number;
  readonly target: Point;
}

/** Vertical field of view, degrees. */
export const FIELD_DEGREES = 32;

const MAX_ELEVATION = Math.PI / 2 - 0.02;
const START = { azimuth: 0.6, elevation: 0.42 } as const;
/** Rotation per key press, radians. */
const KEY_TURN = Math.PI / 24;
const KEY_ZOOM = 1.15;

/** Returns a camera that sees a whole sphere. */
export function startOrbit({ center, radius }: Sphere): Orbit {
  const distance = (radius * 1.15) / Math.sin((FIELD_DEGREES * Math.PI) / 360);
  return { ...START, distance, target: center };
}

export function turn(orbit: Orbit, byAzimuth: number, byElevation: number): Orbit {
  const elevation = Math.max(
    -MAX_ELEVATION,
    Math.min(MAX_ELEVATION, orbit.elevation + byElevation),
  );
  return { ...orbit, azimuth: orbit.azimuth + byAzimuth, elevation };
}

/** @param factor above 1 zooms out */
export function zoom(orbit: Orbit, factor: number): Orbit {
  return { ...orbit, distance: Math.min(1e6, Math.max(1e-3, orbit.distance * factor)) };
}

/** Moves the target in the plane of the screen, by fractions of the visible height. */
export function pan(orbit: Orbit, right: number, up: number, upAxis: Up): Orbit {
  const height = 2 * orbit.distance * Math.tan((FIELD_DEGREES * Math.PI) / 360);
  const { azimuth: a, elevation: e } = orbit;
  const side = [Math.cos(a), 0, -Math.sin(a)];
  const over = [-Math.sin(a) * Math.sin(e), Math.cos(e), -Math.cos(a) * Math.sin(e)];
  const move = side.map((part, index) => (part * right + over[index]! * up) * height);
  const [x, y, z] = ofUp(move as unknown as Point, upAxis);
  const [tx, ty, tz] = orbit.target;
  return { ...orbit, target: [tx + x, ty + y, tz + z] };
}

/** Returns the camera position in the coordinates of the objects. */
export function eyeOf({ azimuth, elevation, distance, target }: Orbit, upAxis: Up): Point {
  const flat = Math.cos(elevation) * distance;
  const [x, y, z] = ofUp(
    [Math.sin(azimuth) * flat, Math.sin(elevation) * distance, Math.cos(azimuth) * flat],
    upAxis,
  );
  return [target[0] + x, target[1] + y, target[2] + z];
}

/** Converts coordinates with y up to coordinates with `upAxis` up, by a rotation about x. */
function ofUp([x, y, z]: Point, upAxis: Up): Point {
  return upAxis === 'y' ? [x, y, z] : [x, -z, y];
}

/** Returns the camera after a key; undefined for other keys. The caller handles `0` and Home. */
export function orbitKey(
  orbit: Orbit,
  key: string,
  isShift: boolean,
  upAxis: Up,
): Orbit | undefined {
  const step = 0.06;
  switch (key) {
    case 'ArrowLeft':
      return isShift ? pan(orbit, -step, 0, upAxis) : turn(orbit, -KEY_TURN, 0);
    case 'ArrowRight':
      return isShift ? pan(orbit, step, 0, upAxis) : turn(orbit, KEY_TURN, 0);
    case 'ArrowUp':
      return isShift ? pan(orbit, 0, step, upAxis) : turn(orbit, 0, KEY_TURN);
    case 'ArrowDown':
      return isShift ? pan(orbit, 0, -step, upAxis) : turn(orbit, 0, -KEY_TURN);
    case '+':
    case '=':
      return zoom(orbit, 1 / KEY_ZOOM);
    case '-':
    case '_':
      return zoom(orbit, KEY_ZOOM);
    default:
      return undefined;
  }
}
