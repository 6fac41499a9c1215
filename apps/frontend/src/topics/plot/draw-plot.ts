import type { SeriesRing } from '../history/series-ring.ts';
import { gapOf, traceLine, type TimeWindow } from './trace-line.ts';
import type { Range, Tick } from './value-axis.ts';

/** How the lines of one topic are told apart: one colour, three strokes. */
export interface Stroke {
  readonly isDashed: boolean;
  /** `lit` is mixed with ink, `dim` lets the ground through. */
  readonly tone: 'plain' | 'lit' | 'dim';
}

const STROKES: readonly Stroke[] = [
  { isDashed: false, tone: 'plain' },
  { isDashed: true, tone: 'lit' },
  { isDashed: false, tone: 'dim' },
  { isDashed: true, tone: 'dim' },
];

export function strokeOf(line: number): Stroke {
  return STROKES[line % STROKES.length]!;
}

/** Colours as the canvas takes them. */
export interface PlotColors {
  readonly line: string;
  readonly ink: string;
  readonly grid: string;
  readonly zero: string;
  readonly ground: string;
}

export interface PlotPicture {
  readonly ring: SeriesRing;
  readonly window: TimeWindow;
  /** Pixels. */
  readonly height: number;
  readonly range: Range;
  readonly ticks: readonly Tick[];
  /** Vertical lines, equally far apart, both edges included. */
  readonly columns: number;
  readonly isStepped: boolean;
  readonly colors: PlotColors;
  /** Where the reading line stands, pixels, and the values it reads. */
  readonly cursor: { readonly x: number; readonly values: readonly number[] } | undefined;
}

const LINE_WIDTH = 1.5;
const DIM = 0.6;
const LIT = 0.45;
/** How strongly the newest value is drawn on until the next one comes. */
const HELD = 0.3;

/** Pixels from the top for a value. */
export function toY({ min, max }: Range, height: number, value: number): number {
  return height - ((value - min) / (max - min)) * height;
}

/** Draws grid, lines and cursor on a cleared canvas; the words around it are not its business. */
export function drawPlot(context: CanvasRenderingContext2D, picture: PlotPicture): void {
  const { window, height } = picture;
  context.clearRect(0, 0, window.width, height);
  drawGrid(context, picture);
  context.save();
  context.beginPath();
  context.rect(0, 0, window.width, height);
  context.clip();
  const gapMs = gapOf(picture.ring);
  // The first line is drawn last and lies on top.
  for (let line = picture.ring.lines - 1; line >= 0; line--)
    drawLine(context, picture, line, gapMs);
  context.restore();
  if (picture.cursor) drawCursor(context, picture, picture.cursor);
}

function drawGrid(context: CanvasRenderingContext2D, picture: PlotPicture): void {
  const { window, height, range, ticks, columns, colors } = picture;
  context.lineWidth = 1;
  context.setLineDash([]);
  context.strokeStyle = colors.grid;
  context.beginPath();
  for (let i = 0; i < columns; i++) {
    const x = crisp((i / (columns - 1)) * (window.width - 1));
    context.moveTo(x, 0);
    context.lineTo(x, height);
  }
  for (const { value } of ticks) {
    const y = crisp(toY(range, height, value));
    context.moveTo(0, y);
    context.lineTo(window.width, y);
  }
  context.stroke();
  if (range.min > 0 || range.max < 0) return;
  const zero = crisp(toY(range, height, 0));
  context.strokeStyle = colors.zero;
  context.beginPath();
  context.moveTo(0, zero);
  context.lineTo(window.width, zero);
  const ticksPerColumn = 4;
  for (let i = 0; i <= (columns - 1) * ticksPerColumn; i++) {
    const x = crisp((i / ((columns - 1) * ticksPerColumn)) * (window.width - 1));
    context.moveTo(x, zero - 2.5);
    context.lineTo(x, zero + 2.5);
  }
  context.stroke();
}

function drawLine(
  context: CanvasRenderingContext2D,
  picture: PlotPicture,
  line: number,
  gapMs: number,
): void {
  const { ring, window, height, range, colors, isStepped } = picture;
  const { isDashed, tone } = strokeOf(line);
  const yOf = (value: number): number => toY(range, height, value);
  context.lineWidth = LINE_WIDTH;
  context.lineJoin = 'round';
  context.setLineDash(isDashed ? [4, 3] : []);
  context.globalAlpha = tone === 'dim' ? DIM : 1;
  context.strokeStyle = colors.line;
  context.beginPath();
  traceLine(ring, line, { window, toY: yOf, gapMs, isStepped }, context);
  context.stroke();
  if (tone === 'lit') {
    context.globalAlpha = LIT;
    context.strokeStyle = colors.ink;
    context.stroke();
  }
  drawHeld(context, picture, line, yOf);
  context.globalAlpha = 1;
  context.setLineDash([]);
}

/** The newest value stands until the next one comes. */
function drawHeld(
  context: CanvasRenderingContext2D,
  { ring, window, colors }: PlotPicture,
  line: number,
  yOf: (value: number) => number,
): void {
  const last = ring.indexAtOrAfter(window.endMs + 0.001) - 1;
  const value = last < 0 ? Number.NaN : ring.valueAt(line, last);
  if (!Number.isFinite(value)) return;
  const fromMs = Math.max(window.startMs, ring.timeAt(last));
  const x = ((fromMs - window.startMs) / (window.endMs - window.startMs)) * window.width;
  context.globalAlpha = HELD;
  context.setLineDash([]);
  context.strokeStyle = colors.line;
  context.beginPath();
  context.moveTo(x, yOf(value));
  context.lineTo(window.width, yOf(value));
  context.stroke();
}

function drawCursor(
  context: CanvasRenderingContext2D,
  { height, range, colors }: PlotPicture,
  { x, values }: { readonly x: number; readonly values: readonly number[] },
): void {
  context.strokeStyle = colors.ink;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(crisp(x), 0);
  context.lineTo(crisp(x), height);
  context.stroke();
  context.fillStyle = colors.ground;
  context.strokeStyle = colors.line;
  context.lineWidth = 2;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    context.beginPath();
    context.arc(x, toY(range, height, value), 3.5, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
}

const crisp = (pixel: number): number => Math.round(pixel - 0.5) + 0.5;
