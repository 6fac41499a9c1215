import { describe, expect, it } from 'vitest';
import { aGraphOf, aModule } from '../testing/small-graph.ts';
import { perform, redo, seal, startEditing, undo } from './edit-state.ts';

const graph = aGraphOf([aModule('a', { i: 'double' })]);
const move = (x: number) =>
  ({ kind: 'move', positions: new Map([['module:a', { x, y: 0 }]]) }) as const;

describe('the history', () => {
  it('takes a drag as one step', () => {
    let state = startEditing(graph);
    for (const x of [1, 2, 3]) state = perform(state, move(x), 'drag 1');
    state = seal(state);
    state = perform(state, move(9), 'drag 1');
    expect(state.past.map(({ label }) => label)).toEqual(['Move a', 'Move a']);
    state = undo(state);
    expect(state.graph.nodes.get('module:a')?.position).toEqual({ x: 3, y: 0 });
    state = undo(state);
    expect(state.graph).toEqual(graph);
    state = redo(redo(state));
    expect(state.graph.nodes.get('module:a')?.position).toEqual({ x: 9, y: 0 });
  });

  it('does not count what changes nothing', () => {
    const state = perform(startEditing(graph), { kind: 'remove', nodes: ['unknown'] });
    expect(state).toEqual(startEditing(graph));
  });

  it('forgets what could be done again once something else was done', () => {
    let state = undo(perform(startEditing(graph), move(1)));
    expect(state.future).toHaveLength(1);
    state = perform(state, move(2));
    expect(state.future).toHaveLength(0);
  });

  it('shares all that a step does not touch', () => {
    const two = aGraphOf([aModule('a'), aModule('b')]);
    const { graph: after } = perform(startEditing(two), move(1));
    expect(after.nodes.get('module:b')).toBe(two.nodes.get('module:b'));
    expect(after.wires).toBe(two.wires);
  });
});
