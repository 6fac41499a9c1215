import type { Point } from '../model/graph.ts';
import type { Box } from './stage-view.ts';

/** SVG path of a wire, and the position of its chip. */
export interface WirePath {
  readonly d: string;
  readonly middle: Point;
}

/** Cubic curve between two consecutive points of a wire. */
export interface Curve {
  readonly from: Point;
  readonly a: Point;
  readonly b: Point;
  readonly to: Point;
}

/** Corner radius of wires that go back, canvas units. */
const RADIUS = 14;
/** Straight distance of a wire from its socket, canvas units. */
const REACH = 20;
const MIN_BEND = 30;
/** Length of the control handles of curves at bend points, as a share of the curve's length. */
const ROUNDNESS = 0.36;
/** Distance of a backward wire below its ends, canvas units. */
const DETOUR = 60;
/** Largest distance of a wire without bend points beyond its ends, canvas units. */
const ROOM = DETOUR + RADIUS;

const round = (value: number): number => Math.round(value * 10) / 10;
const at = ({ x, y }: Point): string => `${round(x)} ${round(y)}`;

/** Returns the path from an output to an input, through bend points. */
export function wirePath(from: Point, to: Point, points: readonly Point[] = []): WirePath {
  if (goesBack(from, to, points)) {
    const corners = cornersOf(from, to);
    const [, , a, b] = corners as [Point, Point, Point, Point];
    return { d: rounded(corners), middle: middleOf(a, b) };
  }
  const curves = curvesOf(from, to, points);
  const d = curves.map(({ a, b, to: end }) => `C${at(a)} ${at(b)} ${at(end)}`).join('');
  return { d: `M${at(from)}${d}`, middle: middleOfLongest(curves) };
}

/** Returns a box that contains the whole wire. */
export function wireBox(from: Point, to: Point, points: readonly Point[] = []): Box {
  const all = [from, ...points, to];
  const x = Math.min(...all.map((point) => point.x));
  const y = Math.min(...all.map((point) => point.y));
  const width = Math.max(...all.map((point) => point.x)) - x;
  const height = Math.max(...all.map((point) => point.y)) - y;
  const room = points.length > 0 ? ROOM + ROUNDNESS * Math.hypot(width, height) : ROOM;
  return { x: x - room, y: y - room, width: width + 2 * room, height: height + 2 * room };
}

/** A wire without bend points goes back in steps; with bend points, it follows them. */
export const goesBack = (from: Point, to: Point, points: readonly Point[]): boolean =>
  points.length === 0 && to.x - from.x < REACH;

/** One curve per bend point and one to the end: smooth at bend points, horizontal at both sockets. */
export function curvesOf(from: Point, to: Point, points: readonly Point[]): Curve[] {
  if (points.length === 0) {
    const bend = Math.max(MIN_BEND, (to.x - from.x) / 2);
    return [{ from, a: { x: from.x + bend, y: from.y }, b: { x: to.x - bend, y: to.y }, to }];
  }
  const stops = [from, ...points, to];
  const directions = stops.map((_, index): Point => {
    const [before, after] = [stops[index - 1], stops[index + 1]];
    if (before === undefined || after === undefined) return { x: 1, y: 0 };
    const whole = length(before, after) || 1;
    return { x: (after.x - before.x) / whole, y: (after.y - before.y) / whole };
  });
  return stops.slice(1).map((stop, index): Curve => {
    const start = stops[index]!;
    const bend = ROUNDNESS * length(start, stop);
    const [out, into] = [directions[index]!, directions[index + 1]!];
    return {
      from: start,
      a: { x: start.x + out.x * bend, y: start.y + out.y * bend },
      b: { x: stop.x - into.x * bend, y: stop.y - into.y * bend },
      to: stop,
    };
  });
}

export function onCurve({ from, a, b, to }: Curve, t: number): Point {
  const s = 1 - t;
  const [p, q, r, u] = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
  return {
    x: p * from.x + q * a.x + r * b.x + u * to.x,
    y: p * from.y + q * a.y + r * b.y + u * to.y,
  };
}

/** Corners of a backward wire: out, half way down, back, the other half, in. */
export function cornersOf(from: Point, to: Point): readonly Point[] {
  const right = from.x + REACH;
  const left = to.x - REACH;
  const y =
    Math.abs(to.y - from.y) < 4 * RADIUS ? Math.max(from.y, to.y) + DETOUR : (from.y + to.y) / 2;
  return [from, { x: right, y: from.y }, { x: right, y }, { x: left, y }, { x: left, y: to.y }, to];
}

function rounded(corners: readonly Point[]): string {
  let d = `M${at(corners[0]!)}`;
  for (let index = 1; index < corners.length - 1; index += 1) {
    const [before, corner, after] = [corners[index - 1]!, corners[index]!, corners[index + 1]!];
    const radius = Math.min(RADIUS, length(before, corner) / 2, length(corner, after) / 2);
    d += `L${at(towards(corner, before, radius))}Q${at(corner)} ${at(towards(corner, after, radius))}`;
  }
  return `${d}L${at(corners.at(-1)!)}`;
}

/** Centre of the longest curve, away from the bend points, which can be dragged. */
function middleOfLongest(curves: readonly Curve[]): Point {
  let longest = curves[0]!;
  for (const curve of curves) {
    if (length(curve.from, curve.to) > length(longest.from, longest.to)) longest = curve;
  }
  return onCurve(longest, 0.5);
}

const middleOf = (a: Point, b: Point): Point => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
const length = (a: Point, b: Point): number => Math.hypot(b.x - a.x, b.y - a.y);

function towards(from: Point, to: Point, distance: number): Point {
  const whole = length(from, to) || 1;
  const part = distance / whole;
  return { x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part };
}
