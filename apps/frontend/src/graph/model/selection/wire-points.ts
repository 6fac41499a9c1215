import type { GraphCommand } from '../commands/graph-command.ts';
import type { Point, Wire } from '../graph.ts';

/** Adds a bend point to a wire. @param leg index of the bend point that comes after it */
export function addPoint({ id, points }: Wire, leg: number, at: Point): GraphCommand {
  return rerouted('Add bend point', id, points.toSpliced(leg, 0, at));
}

export function movePoint({ id, points }: Wire, index: number, to: Point): GraphCommand {
  return rerouted(
    'Move bend point',
    id,
    points.map((point, at) => (at === index ? to : point)),
  );
}

export function removePoint({ id, points }: Wire, index: number): GraphCommand {
  return rerouted('Remove bend point', id, points.toSpliced(index, 1));
}

/** Removes all bend points of a wire. */
export function removePoints({ id }: Wire): GraphCommand {
  return rerouted('Remove bend points', id, []);
}

function rerouted(label: string, wire: string, points: readonly Point[]): GraphCommand {
  return { kind: 'all', label, commands: [{ kind: 'reroute', wire, points }] };
}
