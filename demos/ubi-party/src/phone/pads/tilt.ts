import { steered } from './stick.ts';

/** Degrees of tilt for a full deflection: the wrists reach it without letting go. */
const FULL_TILT = 32;
const DEAD_ZONE = 0.06;
const RADIANS = Math.PI / 180;

/**
 * Angle by which the right edge of the shown page is below its left edge, degrees, -90 to 90. The same for a phone that
 * lies flat and one that is held upright like a steering wheel.
 *
 * @param beta @param gamma of `deviceorientation`, degrees
 * @param screenAngle `screen.orientation.angle`, degrees
 */
export function tiltOf(beta: number, gamma: number, screenAngle: number): number {
  // Down in the axes of the device, https://www.w3.org/TR/orientation-event/ (Z-X'-Y''), then turned to the screen
  const downX = Math.cos(beta * RADIANS) * Math.sin(gamma * RADIANS);
  const downY = -Math.sin(beta * RADIANS);
  const angle = screenAngle * RADIANS;
  const onScreen = downX * Math.cos(angle) - downY * Math.sin(angle);
  return Math.asin(Math.min(1, Math.max(-1, onScreen))) / RADIANS;
}

/** @param neutral the tilt that drives straight ahead, set by Re-centre, degrees */
export function steeringOfTilt(tilt: number, neutral: number): number {
  return steered((tilt - neutral) / FULL_TILT, DEAD_ZONE);
}
