import { expect, it } from 'vitest';
import { perform, startEditing, undo } from '../model/commands/edit-state.ts';
import { aGraphOf, aModule } from '../model/testing/small-graph.ts';
import { collapseCommand } from './collapse.ts';

const graph = aGraphOf([aModule('a', { in: 'double' }), aModule('b')], { 'a.in': '/t' });
const nodesOf = (ids: readonly string[], from = graph) => ids.map((id) => from.nodes.get(id)!);
const MODULES = ['module:a', 'module:b'];

it('folds nodes, opens them when all are folded, and undo takes it back', () => {
  const folded = perform(startEditing(graph), collapseCommand(nodesOf(MODULES))!);
  expect(nodesOf(MODULES, folded.graph).every(({ isCollapsed }) => isCollapsed)).toBe(true);
  expect(collapseCommand(nodesOf(MODULES, folded.graph))).toMatchObject({ isCollapsed: false });
  expect(folded.graph.wires).toEqual(graph.wires);
  expect(undo(folded).graph).toEqual(graph);
});

it('leaves alone what has only a header', () => {
  expect(collapseCommand(nodesOf(['topic:/t']))).toBeUndefined();
  expect(collapseCommand(nodesOf(['topic:/t', 'module:a']))?.nodes).toEqual(['module:a']);
});
