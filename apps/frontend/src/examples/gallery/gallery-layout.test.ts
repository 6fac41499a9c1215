import { EXAMPLE_SESSIONS, moduleLibrary } from '@ubii/modules';
import { expect, it } from 'vitest';
import { drawnSizeIn } from '../../graph/nodes/drawn-size.ts';
import { graphOf } from '../../graph/model/graph-of.ts';
import { bounds } from '../../graph/model/selection/arrange.ts';
import { placesOf } from '../../graph/editing/places.ts';
import { viewOf } from '../../graph/canvas/stage-view.ts';
import { completeExample } from '../../sessions/examples/complete-example.ts';
import { GALLERY } from './gallery.ts';

/** Size of the canvas in a window of 1440 × 900 pixels, and the height covered at its bottom. */
const CANVAS = { width: 840, height: 856 };
const INSET = 60;
const READABLE_ZOOM = 0.6;

it.each(GALLERY.map(({ id }) => id))('the graph of %s is readable as a whole', (id) => {
  const graph = graphOf(completeExample(EXAMPLE_SESSIONS[id], moduleLibrary()));
  const sizeOf = drawnSizeIn(graph);
  const boxes = [...placesOf(graph)].map(([node, place]) => ({
    id: node,
    ...place,
    ...sizeOf(graph.nodes.get(node)!),
  }));
  expect(viewOf(bounds(boxes), CANVAS, INSET).k).toBeGreaterThan(READABLE_ZOOM);
});
