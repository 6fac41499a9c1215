import { expect, it } from 'vitest';
import { applyCommand } from '../commands/apply-command.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import { graphOf } from '../graph-of.ts';
import type { Graph } from '../graph.ts';
import { constantNode } from '../make-node.ts';
import { aModule, aSessionOf } from '../testing/small-graph.ts';
import { isUnapplied } from './unapplied-value.ts';

const saved = graphOf(aSessionOf([aModule('b', { i: 'double', j: 'double' }, {})], {}));
const BEFORE = '{"double":1}';
const AFTER = '{"double":2}';

const edited = (graph: Graph, command: GraphCommand): Graph => applyCommand(graph, command).graph;
const set = (graph: Graph, json: string | undefined): Graph =>
  edited(graph, { kind: 'setConstant', node: 'module:b', input: 'j', json });
const isChanged = (before: Graph, after: Graph, input?: string): boolean =>
  isUnapplied(before.nodes.get('module:b'), after.nodes.get('module:b')!, input);

it('a constant has to be applied while it differs from what the master has', () => {
  const changed = set(saved, AFTER);
  expect(isChanged(saved, changed, 'j')).toBe(true);
  expect(isChanged(saved, changed, 'i')).toBe(false);
  expect(isChanged(saved, changed)).toBe(true);
  expect(isChanged(saved, set(changed, undefined))).toBe(false);
  expect(isChanged(changed, set(changed, undefined))).toBe(true);
  expect(isChanged(changed, changed)).toBe(false);
});

it('a value node has to be applied when its value changes', () => {
  const node = constantNode('constant:1', BEFORE);
  const graph = edited(saved, { kind: 'add', nodes: [node] });
  const next = edited(graph, { kind: 'setValue', node: node.id, json: AFTER }).nodes.get(node.id)!;
  expect(isUnapplied(graph.nodes.get(node.id), next)).toBe(true);
  expect(isUnapplied(next, next)).toBe(false);
});

it('a node that the master does not have has nothing to apply', () => {
  expect(isUnapplied(undefined, set(saved, AFTER).nodes.get('module:b')!)).toBe(false);
});
