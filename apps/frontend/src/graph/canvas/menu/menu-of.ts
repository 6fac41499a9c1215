import type { Graph } from '../../model/graph.ts';
import { canvasMenu } from './canvas-menu.ts';
import type { MenuEntry, MenuPlace, MenuTarget } from './menu-entry.ts';
import { nodesMenu } from './nodes-menu.ts';
import { socketMenu } from './socket-menu.ts';
import { wireMenu } from './wire-menu.ts';

/** Returns the applicable menu entries for an element of the canvas; none if it was removed. */
export function menuOf(graph: Graph, target: MenuTarget, place: MenuPlace): MenuEntry[] {
  switch (target.kind) {
    case 'nodes':
      return nodesMenu(graph, target.nodes, place);
    case 'wire':
      return wireMenu(graph, target.wire, place);
    case 'socket':
      return socketMenu(graph, target.port, place);
    case 'canvas':
      return canvasMenu(graph, place);
  }
}

/** Nodes that a menu on one node applies to: the whole selection if the node is selected. */
export function nodesMeant(selected: ReadonlySet<string>, node: string): readonly string[] {
  return selected.has(node) ? [...selected] : [node];
}
