import { drawnSizeIn } from '../nodes/drawn-size.ts';
import type { Graph, Point } from '../model/graph.ts';
import { placeNew } from '../model/layout/place-graph.ts';

/** Returns the position of each node: the stored one, otherwise along the data flow, below other nodes. */
export function placesOf(graph: Graph): ReadonlyMap<string, Point> {
  const places = new Map<string, Point>();
  for (const { id, position } of placeNew(graph, drawnSizeIn(graph)).nodes.values()) {
    if (position !== undefined) places.set(id, position);
  }
  return places;
}
