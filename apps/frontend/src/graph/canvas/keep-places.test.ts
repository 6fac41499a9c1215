import { expect, it } from 'vitest';
import { placesOf } from '../editing/places.ts';
import { applyCommand } from '../model/commands/apply-command.ts';
import { graphOf } from '../model/graph-of.ts';
import { topicNode } from '../model/make-node.ts';
import { aModule, aSessionOf } from '../model/testing/small-graph.ts';
import { keepPlaces } from './keep-places.ts';

it('a node without a stored position stays where it is when another is added beside it', () => {
  const graph = graphOf(aSessionOf([aModule('double')]));
  const [id] = [...graph.nodes.keys()];
  const before = placesOf(graph);
  const kept = applyCommand(graph, keepPlaces(graph, before)!).graph;
  const topic = topicNode('/new', { position: { x: -280, y: 0 } });
  const after = placesOf(applyCommand(kept, { kind: 'add', nodes: [topic] }).graph);
  expect(after.get(id!)).toEqual(before.get(id!));
  expect(keepPlaces(kept, before)).toBeUndefined();
});
