import type { Graph, GraphNode, SessionDetails, Wire } from '../graph.ts';
import { frameLeft } from '../nesting.ts';
import { wiresOf } from '../wires-of.ts';
import {
  nothingElsewhere,
  type TopicsElsewhere,
  type FindTopicsElsewhere,
} from './topics-elsewhere.ts';

/** New state of elements of a graph; undefined: removed. */
export interface GraphPatch {
  readonly nodes: ReadonlyMap<string, GraphNode | undefined>;
  readonly wires: ReadonlyMap<string, Wire | undefined>;
  readonly details: SessionDetails | undefined;
}

/** Mutable copy of a graph that records the previous state of changed elements. */
export class GraphEdit {
  readonly #before: Graph;
  #graph: Graph;
  readonly #nodes = new Set<string>();
  readonly #wires = new Set<string>();

  readonly #findElsewhere: FindTopicsElsewhere;
  #elsewhere: TopicsElsewhere | undefined;

  constructor(graph: Graph, findElsewhere = nothingElsewhere) {
    this.#before = graph;
    this.#graph = graph;
    this.#findElsewhere = findElsewhere;
  }

  /** Topics that others use: looked up once, by the first command that needs them. */
  get elsewhere(): TopicsElsewhere {
    return (this.#elsewhere ??= this.#findElsewhere());
  }

  /** Current state. */
  get graph(): Graph {
    return this.#graph;
  }

  putNodes(nodes: Iterable<GraphNode>): void {
    this.#changeNodes([...nodes].map((node) => [node.id, node]));
  }

  /** Removes nodes and their wires; nodes in a removed frame move to the frame around it. */
  removeNodes(ids: Iterable<string>): void {
    const gone = new Set([...ids].filter((id) => this.#graph.nodes.has(id)));
    if (gone.size === 0) return;
    const wires = [...gone].flatMap((id) => {
      const { in: incoming, out } = wiresOf(this.#graph, id);
      return [...incoming, ...out].map((wire) => wire.id);
    });
    this.removeWires(wires);
    const hasFrame = [...gone].some((id) => this.#graph.nodes.get(id)?.kind === 'frame');
    const orphans = hasFrame
      ? [...this.#graph.nodes.values()].filter(
          ({ id, frame }) => frame !== undefined && gone.has(frame) && !gone.has(id),
        )
      : [];
    const left = orphans.map((node) => {
      return { ...node, frame: frameLeft(this.#graph.nodes, node.id, gone) };
    });
    this.#changeNodes([
      ...[...gone].map((id) => [id, undefined] as const),
      ...left.map((node) => [node.id, node] as const),
    ]);
  }

  putWires(wires: Iterable<Wire>): void {
    this.#changeWires([...wires].map((wire) => [wire.id, wire]));
  }

  removeWires(ids: Iterable<string>): void {
    this.#changeWires([...ids].map((id) => [id, undefined]));
  }

  setDetails(details: SessionDetails): void {
    this.#graph = { ...this.#graph, details };
  }

  apply({ nodes, wires, details }: GraphPatch): void {
    this.#changeNodes([...nodes]);
    this.#changeWires([...wires]);
    if (details !== undefined) this.setDetails(details);
  }

  /** Patch from the current state to the original one. */
  undoing(): GraphPatch {
    return this.#patch(this.#before, this.#graph);
  }

  /** Patch from the original state to the current one. */
  redoing(): GraphPatch {
    return this.#patch(this.#graph, this.#before);
  }

  #patch(to: Graph, from: Graph): GraphPatch {
    return {
      nodes: differing(this.#nodes, to.nodes, from.nodes),
      wires: differing(this.#wires, to.wires, from.wires),
      details: to.details === from.details ? undefined : to.details,
    };
  }

  #changeNodes(changes: readonly (readonly [id: string, node: GraphNode | undefined])[]): void {
    const nodes = changed(this.#graph.nodes, changes, this.#nodes);
    if (nodes !== undefined) this.#graph = { ...this.#graph, nodes };
  }

  #changeWires(changes: readonly (readonly [id: string, wire: Wire | undefined])[]): void {
    const wires = changed(this.#graph.wires, changes, this.#wires);
    if (wires !== undefined) this.#graph = { ...this.#graph, wires };
  }
}

/** Returns undefined when nothing changes. */
function changed<T>(
  map: ReadonlyMap<string, T>,
  changes: readonly (readonly [id: string, value: T | undefined])[],
  touched: Set<string>,
): ReadonlyMap<string, T> | undefined {
  const real = changes.filter(([id, value]) => map.get(id) !== value);
  if (real.length === 0) return undefined;
  const copy = new Map(map);
  for (const [id, value] of real) {
    touched.add(id);
    if (value === undefined) copy.delete(id);
    else copy.set(id, value);
  }
  return copy;
}

function differing<T>(
  ids: ReadonlySet<string>,
  to: ReadonlyMap<string, T>,
  from: ReadonlyMap<string, T>,
): ReadonlyMap<string, T | undefined> {
  const entries = [...ids].map((id) => [id, to.get(id)] as const);
  return new Map(entries.filter(([id, value]) => from.get(id) !== value));
}

/** True when the patch changes nothing. */
export function isEmptyPatch({ nodes, wires, details }: GraphPatch): boolean {
  return nodes.size === 0 && wires.size === 0 && details === undefined;
}
