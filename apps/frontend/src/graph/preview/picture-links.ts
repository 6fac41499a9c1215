import type { Graph, ModuleNode } from '../model/graph.ts';
import { wiresOf } from '../model/wires-of.ts';
import { topicOfWire } from '../live/topics-in-graph.ts';

/** A module that reads pictures, and the topics of its results. */
interface Looker {
  readonly images: readonly string[];
  /** Topics of its outputs with detected objects, main output first. */
  readonly found: readonly string[];
}

/** Returns the topics with objects that modules of a session detect in the pictures of a topic. */
export function foundIn(graph: Graph, image: string): string[] {
  return lookersOf(graph).flatMap(({ images, found }) =>
    images.includes(image) ? found.slice(0, 1) : [],
  );
}

/**
 * Returns the topic of the pictures that objects were detected in; `undefined` when no module of the session connects
 * them.
 */
export function pictureOf(graph: Graph, found: string): string | undefined {
  return lookersOf(graph).find((looker) => looker.found.includes(found))?.images[0];
}

/** Cached by version of the wires. */
const LOOKERS = new WeakMap<Graph['wires'], readonly Looker[]>();

function lookersOf(graph: Graph): readonly Looker[] {
  let lookers = LOOKERS.get(graph.wires);
  if (lookers === undefined) {
    const modules = [...graph.nodes.values()].filter((node) => node.kind === 'module');
    lookers = modules.map((node) => lookerOf(graph, node));
    LOOKERS.set(graph.wires, lookers);
  }
  return lookers;
}

function lookerOf(graph: Graph, { id, ports }: ModuleNode): Looker {
  const wires = wiresOf(graph, id);
  const inputs = ports.filter((port) => port.direction === 'in' && port.format === 'image2D');
  const outputs = ports.filter(
    (port) => port.direction === 'out' && port.format === 'object2DList' && !port.isList,
  );
  const topics = (port: string): string[] =>
    [
      ...wires.in.filter(({ to }) => to.port === port),
      ...wires.out.filter(({ from }) => from.port === port),
    ].flatMap((wire) => topicOfWire(graph, wire) ?? []);
  return {
    images: inputs.flatMap((port) => topics(port.id)),
    found: outputs.flatMap((port) => topics(port.id)),
  };
}
