import type { Point } from '../model/graph.ts';

/** How a wire is drawn, and where its chip stands. */
export interface WirePath {
  readonly d: string;
  readonly middle: Point;
}

/** Corners of wires that go back. */
const RADIUS = 14;
/** How far a wire leaves a socket before it turns. */
const REACH = 20;
const MIN_BEND = 30;

const round = (value: number): number => Math.round(value * 10) / 10;
const at = ({ x, y }: Point): string => `${round(x)} ${round(y)}`;

/** From an output to an input, through the points it is led through. */
export function wirePath(from: Point, to: Point, points: readonly Point[] = []): WirePath {
  if (points.length > 0) return through([from, ...points, to]);
  return to.x - from.x >= REACH ? forward(from, to) : backward(from, to);
}

function forward(from: Point, to: Point): WirePath {
  const bend = Math.max(MIN_BEND, (to.x - from.x) / 2);
  return {
    d: `M${at(from)}C${at({ x: from.x + bend, y: from.y })} ${at({ x: to.x - bend, y: to.y })} ${at(to)}`,
    middle: middleOf(from, to),
  };
}

/** Steps with round corners: out, half way down, back, the other half, in. */
function backward(from: Point, to: Point): WirePath {
  const right = from.x + REACH;
  const left = to.x - REACH;
  const y =
    Math.abs(to.y - from.y) < 4 * RADIUS ? Math.max(from.y, to.y) + 60 : (from.y + to.y) / 2;
  const corners = [
    from,
    { x: right, y: from.y },
    { x: right, y },
    { x: left, y },
    { x: left, y: to.y },
    to,
  ];
  return { d: rounded(corners), middle: { x: (left + right) / 2, y } };
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

/** A curve through all points, flat at both ends. */
function through(points: readonly Point[]): WirePath {
  let d = `M${at(points[0]!)}`;
  for (let index = 1; index < points.length; index += 1) {
    const [from, to] = [points[index - 1]!, points[index]!];
    const bend = Math.max(MIN_BEND, Math.abs(to.x - from.x) / 2);
    d += `C${at({ x: from.x + bend, y: from.y })} ${at({ x: to.x - bend, y: to.y })} ${at(to)}`;
  }
  return { d, middle: points[Math.floor(points.length / 2)]! };
}

const middleOf = (a: Point, b: Point): Point => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
const length = (a: Point, b: Point): number => Math.hypot(b.x - a.x, b.y - a.y);

function towards(from: Point, to: Point, distance: number): Point {
  const whole = length(from, to) || 1;
  const part = distance / whole;
  return { x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part };
}
