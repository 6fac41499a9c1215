import { plural } from '@ubii/words';
import * as v from 'valibot';
import { importedValue, type ImportKind } from '../../../json/read-imported.ts';
import { readStored } from '../../../json/read-stored.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import type { Graph, GraphNode, Point, Wire } from '../graph.ts';
import { wireId } from '../graph.ts';
import { topicsOf, unusedTopic } from '../commands/free-topic.ts';
import { CLIPBOARD, nodeFromJson, nodeToJson, wireToJson } from './clipboard-json.ts';
import { withContents } from '../nesting.ts';
import { wiresOf } from '../wires-of.ts';

/** Value of `format` that marks a text as copied nodes. */
export const CLIPBOARD_FORMAT = 'ubi-interact.nodes';
const VERSION = 1;

/** Longest text that is parsed, characters. */
const MAX_LENGTH = 8_000_000;

const KIND: ImportKind = {
  what: 'nodes of a graph',
  mark: ['format', CLIPBOARD_FORMAT],
  version: ['version', VERSION],
  maxChars: MAX_LENGTH,
};
const OURS = v.looseObject({ format: v.literal(CLIPBOARD_FORMAT) });

/** Serialises nodes and the wires between them. */
export function copyText(graph: Graph, ids: Iterable<string>): string {
  const chosen = withContents(graph, ids);
  const nodes = [...graph.nodes.values()].filter(({ id }) => chosen.has(id));
  const wires = nodes.flatMap(({ id }) =>
    wiresOf(graph, id).out.filter(({ to }) => chosen.has(to.node)),
  );
  return JSON.stringify(
    {
      format: CLIPBOARD_FORMAT,
      version: VERSION,
      nodes: nodes.map(nodeToJson),
      wires: wires.map(wireToJson),
    },
    undefined,
    1,
  );
}

/** Options for pasting nodes. */
export interface PasteOptions {
  /** Returns a new UUID. */
  uuid(): string;
  /** Top left of the pasted nodes; default: slightly offset from the originals. */
  readonly position?: Point | undefined;
  readonly label?: string;
}

/** Result of pasting a text, or the reason why it cannot be pasted. */
export type Pasted =
  | { readonly kind: 'nodes'; readonly command: GraphCommand; readonly ids: readonly string[] }
  /** Text of another program, which this editor does not paste. */
  | { readonly kind: 'foreign' }
  | { readonly kind: 'broken'; readonly reason: string };

const OFFSET = 32;

/**
 * Pastes nodes with new ids. Topic nodes keep their topic; topics between modules get new names, so that the copy does
 * not write to the original.
 */
export function paste(graph: Graph, text: string, options: PasteOptions): Pasted {
  const json = text.includes(CLIPBOARD_FORMAT) ? readStored(OURS, text, MAX_LENGTH) : undefined;
  if (json === undefined) return { kind: 'foreign' };
  const read = importedValue(KIND, CLIPBOARD, json, 'text');
  if (read.kind === 'broken') return { kind: 'broken', reason: read.message };
  const ids = new Map<string, string>();
  const nodes = read.value.nodes.map((one) => nodeFromJson(one, options.uuid, ids));
  const wires = wiresFromJson(graph, read.value.wires, ids);
  const placed = inPlace(graph, nodes, ids, options.position);
  const topics = placed.filter(({ kind, id }) => kind === 'topic' && graph.nodes.has(id));
  const added = placed.filter((node) => !topics.includes(node));
  const label =
    options.label ?? `Paste ${plural(placed.length, 'a node', `${placed.length} nodes`)}`;
  return {
    kind: 'nodes',
    command: { kind: 'add', nodes: added, wires, label },
    ids: placed.map(({ id }) => id),
  };
}

/** Duplicates nodes beside the originals. */
export function duplicate(
  graph: Graph,
  ids: Iterable<string>,
  uuid: () => string,
): Extract<Pasted, { kind: 'nodes' }> | undefined {
  const chosen = [...ids].filter((id) => graph.nodes.get(id)?.kind !== 'topic');
  const label = `Duplicate ${plural(chosen.length, 'a node', `${chosen.length} nodes`)}`;
  const pasted = paste(graph, copyText(graph, chosen), { uuid, label });
  return pasted.kind === 'nodes' && pasted.ids.length > 0 ? pasted : undefined;
}

function wiresFromJson(
  graph: Graph,
  list: v.InferOutput<typeof CLIPBOARD>['wires'],
  ids: ReadonlyMap<string, string>,
): Wire[] {
  const topics = new Map<string, string>();
  const taken = topicsOf(graph);
  const newTopic = (via: string): string => {
    let topic = topics.get(via);
    if (topic === undefined) {
      topic = unusedTopic(taken, via);
      taken.add(topic);
      topics.set(via, topic);
    }
    return topic;
  };
  return list.flatMap(({ from: [fromNode, fromPort], to: [toNode, toPort], via }) => {
    const [source, target] = [ids.get(fromNode), ids.get(toNode)];
    if (source === undefined || target === undefined) return [];
    const from = { node: source, port: fromPort };
    const to = { node: target, port: toPort };
    const topic = via === undefined ? undefined : newTopic(via);
    return [{ id: wireId(from, to), from, to, via: topic, points: [] }];
  });
}

function inPlace(
  graph: Graph,
  nodes: readonly GraphNode[],
  ids: ReadonlyMap<string, string>,
  position: Point | undefined,
): GraphNode[] {
  const points = nodes.flatMap((node) => node.position ?? []);
  const left = Math.min(...points.map(({ x }) => x));
  const top = Math.min(...points.map(({ y }) => y));
  const by = position ? { x: position.x - left, y: position.y - top } : { x: OFFSET, y: OFFSET };
  return nodes.map((node) => ({
    ...node,
    frame: frameOf(graph, node, ids),
    position: node.position && { x: node.position.x + by.x, y: node.position.y + by.y },
  }));
}

/** The copied frame if it was copied, too; otherwise the original frame, if it exists. */
function frameOf(
  graph: Graph,
  { frame }: GraphNode,
  ids: ReadonlyMap<string, string>,
): string | undefined {
  if (frame === undefined) return undefined;
  return ids.get(frame) ?? (graph.nodes.has(frame) ? frame : undefined);
}
