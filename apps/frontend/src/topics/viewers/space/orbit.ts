import type { Sphere } from './framing.ts';
import type { Point } from './space-things.ts';

/** Which axis points up on the screen. */
export type Up = 'y' | 'z';

/** Where the eye is: around a target, at a distance. */
export interface Orbit {
  /** About the up axis, radians; 0 looks along the axis that comes towards the viewer. */
  readonly azimuth: number;
  /** Above the ground, radians, from just above straight down to just below straight up. */
  readonly elevation: number;
  readonly distance: number;
  readonly target: Point;
}

/** The height of what is seen, degrees. */
export const FIELD_DEGREES = 32;

const MOST_ELEVATION = Math.PI / 2 - 0.02;
const START = { azimuth: 0.6, elevation: 0.42 } as const;
/** A key turns by so much, radians. */
const KEY_TURN = Math.PI / 24;
const KEY_ZOOM = 1.15;

/** An eye that sees everything in a sphere. */
export function startOrbit({ center, radius }: Sphere): Orbit {
  const distance = (radius * 1.15) / Math.sin((FIELD_DEGREES * Math.PI) / 360);
  return { ...START, distance, target: center };
}

export function turn(orbit: Orbit, byAzimuth: number, byElevation: number): Orbit {
  const elevation = Math.max(
    -MOST_ELEVATION,
    Math.min(MOST_ELEVATION, orbit.elevation + byElevation),
  );
  return { ...orbit, azimuth: orbit.azimuth + byAzimuth, elevation };
}

/** @param factor above 1 goes away */
export function zoom(orbit: Orbit, factor: number): Orbit {
  return { ...orbit, distance: Math.min(1e6, Math.max(1e-3, orbit.distance * factor)) };
}

/** Moves the target in the plane of the screen, by parts of the height that is seen. */
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

/** Where the eye is, in the coordinates of the things. */
export function eyeOf({ azimuth, elevation, distance, target }: Orbit, upAxis: Up): Point {
  const flat = Math.cos(elevation) * distance;
  const [x, y, z] = ofUp(
    [Math.sin(azimuth) * flat, Math.sin(elevation) * distance, Math.cos(azimuth) * flat],
    upAxis,
  );
  return [target[0] + x, target[1] + y, target[2] + z];
}

/** What is meant with y up, where z is up: the same turned about x. */
function ofUp([x, y, z]: Point, upAxis: Up): Point {
  return upAxis === 'y' ? [x, y, z] : [x, -z, y];
}

/** What a key does; nothing for keys that mean nothing here. `0` and Home are the caller's. */
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
