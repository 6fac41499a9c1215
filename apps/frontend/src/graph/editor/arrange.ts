import type { Graph, Point } from '../model/graph.ts';
import { placesOf } from './places.ts';

/** Where nodes would stand if nobody had placed them. */
export async function arranged(graph: Graph): Promise<ReadonlyMap<string, Point>> {
  const loose = [...graph.nodes].map(
    ([id, node]) => [id, { ...node, position: undefined }] as const,
  );
  return placesOf({ ...graph, nodes: new Map(loose) });
}
