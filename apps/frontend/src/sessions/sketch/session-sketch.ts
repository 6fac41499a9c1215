import type { DataFormatFamily, ProcessingModule, Session } from '@ubii/proto';
import { shortened } from '@ubii/words';
import { formatLook } from '../../formats/families.ts';
import { mappedModule, type MappingEnd } from '../words/mapping-words.ts';

/** Box in the sketch: a module, or a topic, constant, muxer or demuxer. */
export interface SketchBox {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly kind: 'module' | 'topic';
  /** Of a module, cut to what fits between its neighbours; empty for others. */
  readonly name: string;
  /** True with an error. */
  readonly isTroubled: boolean;
}

/** Path of a connection. */
export interface SketchWire {
  readonly path: string;
  readonly family: DataFormatFamily;
}

/** Layout of a session as a picture of 96 × 54 units: topics at the sides, modules between them in columns. */
export interface SessionSketch {
  readonly boxes: readonly SketchBox[];
  readonly wires: readonly SketchWire[];
}

const WIDTH = 96;
const HEIGHT = 54;
const MARGIN = 6;
/** Most boxes per column; more cannot be distinguished. */
const MAX_ROWS = 4;
const MAX_COLUMNS = 9;
const MODULE = { width: 18, height: 12 };
/** Topics are drawn as test points. */
const TOPIC = { width: 4, height: 4 };
/** Mean width of a letter of a name. */
const LETTER = 1.6;
/** Smallest gap between columns, while there is room. */
const GAP = 6;

interface Node {
  readonly key: string;
  readonly kind: 'module' | 'topic';
  readonly name: string;
  column: number;
  readonly isTroubled: boolean;
}
interface Link {
  readonly from: string;
  readonly to: string;
  readonly family: DataFormatFamily;
}

const endKey = (end: MappingEnd): string | undefined => {
  if (end.kind === 'topic') return `topic ${end.topic}`;
  if (end.kind === 'muxer' || end.kind === 'demuxer') return `${end.kind} ${end.pattern}`;
  return undefined;
};

export function sessionSketch(session: Session): SessionSketch {
  const { nodes, links } = graphOf(session);
  assignColumns(nodes, links);
  const columns = groupByColumn([...nodes.values()]);
  const places = new Map<string, SketchBox>();
  const hasModules = columns.map((column) => column.some(({ kind }) => kind === 'module'));
  const moduleColumns = hasModules.filter(Boolean).length;
  const room = WIDTH - 2 * MARGIN - (columns.length - moduleColumns) * TOPIC.width;
  const moduleWidth = Math.max(
    4,
    Math.min(MODULE.width, (room - (columns.length - 1) * GAP) / Math.max(1, moduleColumns)),
  );
  const widths = hasModules.map((has) => (has ? moduleWidth : TOPIC.width));
  const total = widths.reduce((sum, width) => sum + width, 0);
  const gaps = Math.max(1, columns.length - 1);
  const gap = Math.max(1, Math.min(14, (WIDTH - 2 * MARGIN - total) / gaps));
  let x = (WIDTH - total - gap * (columns.length - 1)) / 2;
  columns.forEach((column, index) => {
    const columnWidth = widths[index] ?? 0;
    column.forEach(({ key, kind, name, isTroubled }, row) => {
      const size = kind === 'module' ? MODULE : TOPIC;
      const height = Math.min(size.height, HEIGHT / (column.length + 1) - 2);
      const width = kind === 'module' ? moduleWidth : TOPIC.width;
      places.set(key, {
        x: x + (columnWidth - width) / 2,
        y: (HEIGHT * (row + 1)) / (column.length + 1) - height / 2,
        width,
        height,
        kind,
        name: shortened(name, Math.floor((width + gap) / LETTER)),
        isTroubled,
      });
    });
    x += columnWidth + gap;
  });
  const wires = links.flatMap(({ from, to, family }) => {
    const a = places.get(from);
    const b = places.get(to);
    return a && b ? [{ path: wirePath(a, b), family }] : [];
  });
  return { boxes: [...places.values()], wires };
}

function graphOf(session: Session): { nodes: Map<string, Node>; links: Link[] } {
  const nodes = new Map<string, Node>();
  const links: Link[] = [];
  const troubled = new Set(
    (session.extension?.problems ?? []).filter((one) => one.isError).map((one) => one.moduleId),
  );
  const moduleKey = ({ id }: ProcessingModule): string => `module ${id}`;
  for (const module of session.processingModules) {
    const key = moduleKey(module);
    const isTroubled = troubled.has(module.id);
    nodes.set(key, { key, kind: 'module', name: module.name, column: 0, isTroubled });
  }
  const addTopic = (key: string): void => {
    if (nodes.has(key)) return;
    nodes.set(key, { key, kind: 'topic', name: '', column: 0, isTroubled: false });
  };
  for (const module of session.processingModules) {
    const { inputs, outputs } = mappedModule(module, session);
    for (const [list, isInput] of [
      [inputs, true],
      [outputs, false],
    ] as const) {
      for (const { end, format } of list) {
        const key = endKey(end);
        if (key === undefined) continue;
        addTopic(key);
        const { family } = formatLook(format);
        const [from, to] = isInput ? [key, moduleKey(module)] : [moduleKey(module), key];
        links.push({ from, to, family });
      }
    }
  }
  return { nodes, links };
}

/** Assigns each node to a column right of its sources; the number of rounds is limited because of cycles. */
function assignColumns(nodes: Map<string, Node>, links: readonly Link[]): void {
  for (let round = 0; round < MAX_COLUMNS; round += 1) {
    for (const { from, to } of links) {
      const a = nodes.get(from);
      const b = nodes.get(to);
      if (a && b && b.column <= a.column && a.column < MAX_COLUMNS - 1) b.column = a.column + 1;
    }
  }
  // Nodes without sources are placed next to their targets.
  const hasSource = new Set(links.map(({ to }) => to));
  for (const node of nodes.values()) {
    if (hasSource.has(node.key)) continue;
    const targets = links.filter(({ from }) => from === node.key);
    const columns = targets.map(({ to }) => nodes.get(to)?.column ?? 1);
    if (columns.length > 0) node.column = Math.max(0, Math.min(...columns) - 1);
  }
}

function groupByColumn(nodes: readonly Node[]): Node[][] {
  const columns: Node[][] = [];
  for (const node of nodes) (columns[node.column] ??= []).push(node);
  return columns.filter((column) => column !== undefined).map((one) => one.slice(0, MAX_ROWS));
}

function wirePath(a: SketchBox, b: SketchBox): string {
  const from = { x: a.x + a.width, y: a.y + a.height / 2 };
  const to = { x: b.x, y: b.y + b.height / 2 };
  const bend = Math.max(4, (to.x - from.x) / 2);
  const n = (value: number): string => value.toFixed(1);
  return `M${n(from.x)} ${n(from.y)}C${n(from.x + bend)} ${n(from.y)} ${n(to.x - bend)} ${n(to.y)} ${n(to.x)} ${n(to.y)}`;
}
