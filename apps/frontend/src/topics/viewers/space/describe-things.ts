import { formatNumber } from '../../../ui/readouts/format-number.ts';
import type { Axes, SpaceThing, SpaceView } from './space-things.ts';

const DEGREES = 180 / Math.PI;

/** Rotations about z, y and x of the rotated body, degrees; the length of axes is ignored. */
export function anglesOf([x, y, z]: Axes): { yaw: number; pitch: number; roll: number } {
  const length = Math.hypot(...x) || 1;
  return {
    yaw: Math.atan2(x[1], x[0]) * DEGREES,
    pitch: Math.asin(Math.max(-1, Math.min(1, -x[2] / length))) * DEGREES,
    roll: Math.atan2(y[2], z[2]) * DEGREES,
  };
}

const degrees = (value: number): string => `${formatNumber(Math.round(value) + 0)}°`;

/** Describes an object in words and numbers. */
export function describeThing({ name, at, axes, mark }: SpaceThing): string {
  const isTurned = axes !== undefined && mark === 'axes';
  // A pure rotation is at the origin: omit the position.
  const isThere = !isTurned || at.some((part) => part !== 0);
  const words = [name, isThere ? `at ${at.map((part) => formatNumber(part, 2)).join(', ')}` : ''];
  if (isTurned) {
    const { yaw, pitch, roll } = anglesOf(axes);
    words.push(`yaw ${degrees(yaw)}`, `pitch ${degrees(pitch)}`, `roll ${degrees(roll)}`);
  }
  return words.filter((word) => word !== '').join('  ');
}

/** Text description of the picture, for screen readers. */
export function describeView({ things, count }: SpaceView): string {
  if (count === 0) return 'Nothing to draw.';
  if (count === 1) return describeThing(things[0]!);
  const left = count > things.length ? `, the first ${things.length} are drawn` : '';
  return `${formatNumber(count)} things${left}`;
}
