import type { DataFormatFamily, Image2D } from '@ubii/proto';
import { formatFixed } from '../../../topics/values/format-value.ts';
import { linePath } from '../../../ui/charts/line-path.ts';
import { formatNumber } from '../../../ui/readouts/format-number.ts';
import type { PreviewView } from '../gallery.ts';
import { WINDOW_MS, type PreviewMemory } from './preview-memory.ts';

/** Size of the drawing, in its own units. */
export const FRAME_WIDTH = 320;
export const FRAME_HEIGHT = 160;
const MARGIN = 14;
/** Width for letters and values at the ends of lines. */
const END = 62;
/** Minimum distance between values at the ends of lines. */
const LABEL_HEIGHT = 15;

/** One frame of a preview, ready to be drawn. */
export interface PreviewFrame {
  readonly paths: readonly {
    readonly d: string;
    readonly family: DataFormatFamily;
    readonly stroke: 'solid' | 'light' | 'dashed' | 'level';
  }[];
  readonly labels: readonly {
    readonly y: number;
    readonly letter: string;
    readonly text: string;
  }[];
  /** Marks of events, pixels from the left. */
  readonly marks: readonly number[];
  readonly dots: readonly {
    readonly x: number;
    readonly y: number;
    readonly kind: 'ring' | 'dot';
  }[];
  readonly readout: { readonly text: string; readonly unit: string } | undefined;
  /** CSS colour of the whole surface. */
  readonly fill: string | undefined;
  readonly pictures: readonly Image2D[];
  readonly isPressed: boolean;
}

const EMPTY: PreviewFrame = {
  paths: [],
  labels: [],
  marks: [],
  dots: [],
  readout: undefined,
  fill: undefined,
  pictures: [],
  isPressed: false,
};

type ViewOf<K extends PreviewView['kind']> = Extract<PreviewView, { kind: K }>;

/** Returns the frame of a view at a time. Pure. */
export function previewFrame(
  view: PreviewView,
  memory: PreviewMemory,
  nowMs: number,
): PreviewFrame {
  switch (view.kind) {
    case 'lines':
      return linesFrame(view, memory, nowMs);
    case 'surface':
      return surfaceFrame(view, memory);
    case 'color': {
      const color = memory.color(view.color);
      const parts = color && [color.r, color.g, color.b];
      return {
        ...EMPTY,
        fill: parts && `color(srgb ${parts.join(' ')})`,
        dots: dotOf(memory, view.pointer, 'ring'),
        readout: readoutOf(memory.text(view.hex), ''),
      };
    }
    case 'count':
      return {
        ...EMPTY,
        readout: readoutOf(memory.number(view.count)?.toFixed(0), ''),
        isPressed: memory.isTrue(view.pressed),
      };
    case 'pictures':
      return {
        ...EMPTY,
        pictures: view.topics.flatMap((topic) => memory.picture(topic) ?? []),
      };
    case 'text':
      return { ...EMPTY, readout: readoutOf(memory.text(view.text) || undefined, '') };
  }
}

const readoutOf = (text: string | undefined, unit: string): PreviewFrame['readout'] =>
  text === undefined ? undefined : { text, unit };

/** Converts a position from 0 to 1 to the drawing. */
const onSurface = ({ x, y }: { readonly x: number; readonly y: number }) => ({
  x: MARGIN + x * (FRAME_WIDTH - 2 * MARGIN),
  y: MARGIN + y * (FRAME_HEIGHT - 2 * MARGIN),
});

function dotOf(memory: PreviewMemory, topic: string, kind: 'ring' | 'dot'): PreviewFrame['dots'] {
  const position = memory.position(topic);
  return position === undefined ? [] : [{ ...onSurface(position), kind }];
}

function linesFrame(view: ViewOf<'lines'>, memory: PreviewMemory, nowMs: number): PreviewFrame {
  const [low, high] = view.range;
  const width = FRAME_WIDTH - END;
  const xOf = (atMs: number): number => width - ((nowMs - atMs) / WINDOW_MS) * width;
  const yOf = (value: number): number =>
    MARGIN +
    (1 - (Math.min(high, Math.max(low, value)) - low) / (high - low)) * (FRAME_HEIGHT - 2 * MARGIN);
  const levels = (view.levels ?? []).map((level) => ({
    d: `M0 ${yOf(level).toFixed(1)}H${width}`,
    family: 'system' as const,
    stroke: 'level' as const,
  }));
  const lines = view.lines.map(({ topic, stroke }) => ({
    d: linePath(memory.series(topic).map(({ atMs, value }) => ({ x: xOf(atMs), y: yOf(value) }))),
    family: 'number' as const,
    stroke,
  }));
  const labels = view.lines.flatMap(({ topic, letter }) => {
    const value = memory.number(topic);
    const decimals = high - low > 20 ? 0 : 2;
    return value === undefined
      ? []
      : [{ y: yOf(value), letter, text: formatNumber(value, decimals) }];
  });
  const readout = view.readout && memory.number(view.readout.topic);
  return {
    ...EMPTY,
    paths: [...levels, ...lines],
    labels: apart(labels),
    marks: (view.events ?? []).flatMap((topic) =>
      memory
        .series(topic)
        .map(({ atMs }) => xOf(atMs))
        .filter((x) => x >= 0),
    ),
    dots: view.pointer === undefined ? [] : dotOf(memory, view.pointer, 'ring'),
    readout:
      view.readout && readout !== undefined
        ? { text: formatFixed(readout, Number.isInteger(readout) ? 0 : 2), unit: view.readout.unit }
        : undefined,
  };
}

/** Moves labels apart, so that they do not overlap; keeps their order. */
function apart(labels: PreviewFrame['labels']): PreviewFrame['labels'] {
  let least = 0;
  const sorted = [...labels].sort((a, b) => a.y - b.y);
  const down = sorted.map((label) => {
    const y = Math.max(label.y, least);
    least = y + LABEL_HEIGHT;
    return { ...label, y };
  });
  const over = Math.max(0, least - LABEL_HEIGHT - (FRAME_HEIGHT - MARGIN / 2));
  return down.map((label) => ({ ...label, y: label.y - over }));
}

function surfaceFrame(view: ViewOf<'surface'>, memory: PreviewMemory): PreviewFrame {
  const middle = view.middle === undefined ? undefined : memory.position(view.middle);
  const points = (view.points ?? []).flatMap((topic) => memory.position(topic) ?? []);
  const at = (position: { readonly x: number; readonly y: number }): string => {
    const { x, y } = onSurface(position);
    return `${x.toFixed(1)} ${y.toFixed(1)}`;
  };
  return {
    ...EMPTY,
    paths: [
      ...view.trails.map(({ topic, stroke }) => ({
        d: linePath(memory.trail(topic).map(({ value }) => onSurface(value))),
        family: 'vector' as const,
        stroke,
      })),
      ...(middle === undefined
        ? []
        : points.map((point) => ({
            d: `M${at(point)}L${at(middle)}`,
            family: 'vector' as const,
            stroke: 'light' as const,
          }))),
    ],
    dots: [
      ...points.map((point) => ({ ...onSurface(point), kind: 'ring' as const })),
      ...view.trails.slice(-1).flatMap(({ topic }) => dotOf(memory, topic, 'dot')),
      ...(middle === undefined ? [] : [{ ...onSurface(middle), kind: 'dot' as const }]),
    ],
  };
}
