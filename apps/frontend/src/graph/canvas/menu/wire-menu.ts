import type { Graph } from '../../model/graph.ts';
import { onGrid } from '../free-spot.ts';
import { addPoint, removePoints } from '../../model/selection/wire-points.ts';
import { topicOfWire } from '../../live/topics-in-graph.ts';
import { action, separated, type MenuEntry, type MenuPlace } from './menu-entry.ts';

/** Returns the menu entries for a wire, at the place of the pointer. */
export function wireMenu(graph: Graph, id: string, { at, spotOn }: MenuPlace): MenuEntry[] {
  const wire = graph.wires.get(id);
  if (wire === undefined) return [];
  const topic = topicOfWire(graph, wire);
  const spot = spotOn(id);
  return separated(
    [
      action('Insert module…', { request: { kind: 'add', at, wire: id } }),
      ...(spot === undefined
        ? []
        : [
            action(
              'Add bend point',
              { command: addPoint(wire, spot.leg, onGrid(spot)) },
              { shortcut: 'R' },
            ),
          ]),
      ...(wire.points.length > 0
        ? [action('Remove bend points', { command: removePoints(wire) })]
        : []),
    ],
    [
      ...(wire.via === undefined
        ? []
        : [
            action('Show topic as node', {
              command: { kind: 'showTopic', wire: id, position: onGrid(at) },
            }),
          ]),
      ...(topic === undefined
        ? []
        : [action('Open topic', { request: { kind: 'open topic', name: topic } })]),
    ],
    [
      action(
        'Delete',
        { command: { kind: 'remove', wires: [id] } },
        { shortcut: 'Del', isDanger: true },
      ),
    ],
  );
}
