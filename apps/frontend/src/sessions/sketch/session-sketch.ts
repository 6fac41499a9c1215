import type { DataFormatFamily, ProcessingModule, Session } from '@ubii/proto';
import { formatLook } from '../../formats/families.ts';
import { mappedModule, type MappingEnd } from '../words/mapping-words.ts';

/** A box of the sketch: a module, or what is at the end of a wire. */
export interface SketchBox {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly kind: 'module' | 'topic';
  /** It has an error. */
  readonly isTroubled: boolean;
}

/** A wire of the sketch, as a path. */
export interface SketchWire {
  readonly path: string;
  readonly family: DataFormatFamily;
}

/** A session as a small picture of 96 × 54: topics at the sides, modules between them in columns. */
export interface SessionSketch {
  readonly boxes: readonly SketchBox[];
  readonly wires: readonly SketchWire[];
}

const WIDTH = 96;
const HEIGHT = 54;
const MARGIN = 6;
/** More of them cannot be told apart. */
const MAX_ROWS = 4;
const MAX_COLUMNS = 4;

interface Node {
  readonly key: string;
  readonly kind: 'module' | 'topic';
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
  columns.forEach((column, index) => {
    const height = Math.min(12, (HEIGHT - 2 * MARGIN) / column.length - 4);
    const width = Math.min(20, (WIDTH - 2 * MARGIN) / columns.length - 6);
    const step = (WIDTH - 2 * MARGIN - width) / Math.max(1, columns.length - 1);
    column.forEach((node, row) => {
      const x = columns.length === 1 ? (WIDTH - width) / 2 : MARGIN + index * step;
      const y = (HEIGHT * (row + 1)) / (column.length + 1) - height / 2;
      const { kind, isTroubled } = node;
      places.set(node.key, { x, y, width, height, kind, isTroubled });
    });
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
    nodes.set(key, { key, kind: 'module', column: 0, isTroubled: troubled.has(module.id) });
  }
  const addTopic = (key: string): void => {
    if (!nodes.has(key)) nodes.set(key, { key, kind: 'topic', column: 0, isTroubled: false });
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

/** Each node stands right of what flows into it; cycles end after as many rounds as there are columns. */
function assignColumns(nodes: Map<string, Node>, links: readonly Link[]): void {
  for (let round = 1; round < MAX_COLUMNS + 1; round += 1) {
    for (const { from, to } of links) {
      const a = nodes.get(from);
      const b = nodes.get(to);
      if (a && b && b.column <= a.column && a.column < MAX_COLUMNS) b.column = a.column + 1;
    }
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
