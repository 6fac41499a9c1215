import { decode, encode } from '@ubii/proto';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { graphOf } from '../graph-of.ts';
import type { Graph } from '../graph.ts';
import { sessionOf } from '../session-of.ts';
import { arbitrarySession } from '../testing/arbitrary-session.ts';
import { numbersOf, randomCommand } from '../testing/random-command.ts';
import { withIds } from '../with-ids.ts';
import { applyCommand } from './apply-command.ts';
import { perform, redo, startEditing, undo, type EditState } from './edit-state.ts';

const SESSION = 'ubii.sessions.Session';
const numbers = fc.array(fc.nat(60), { minLength: 1, maxLength: 60 });

function counter(): () => string {
  let count = 0;
  return () => `id${(count += 1)}`;
}

/** Returns a graph after random commands, with its history. */
function edited(graph: Graph, list: readonly number[]): EditState {
  const next = numbersOf(list);
  let state = startEditing(graph);
  for (let i = 0; i < 12; i += 1) state = perform(state, randomCommand(state.graph, next));
  return state;
}

/** Returns the content of a graph that a session stores: without ports that are not mapped. */
function told(graph: Graph): object {
  const nodes = [...graph.nodes].map(([id, { ports: _ports, ...node }]) => [id, node] as const);
  return {
    nodes: new Map(nodes),
    // Two equal wires have no defined order, and only the first keeps its bend points.
    wires: [...graph.wires.values()]
      .map(({ id, ...wire }) => JSON.stringify(id.includes('#') ? { ...wire, points: [] } : wire))
      .sort(),
    details: graph.details,
    foreign: graph.foreign,
  };
}

/** Many sessions take long on a busy computer. */
const TIMEOUT_MS = 60_000;

describe('commands on any graph', { timeout: TIMEOUT_MS }, () => {
  it('are undone exactly, one by one', () => {
    fc.assert(
      fc.property(arbitrarySession, numbers, (session, list) => {
        const next = numbersOf(list);
        let graph = graphOf(session);
        for (let i = 0; i < 8; i += 1) {
          const { graph: after, inverse } = applyCommand(graph, randomCommand(graph, next));
          expect(applyCommand(after, inverse).graph).toEqual(graph);
          graph = after;
        }
      }),
      { numRuns: 300 },
    );
  });

  it('are undone and done again, all of them', () => {
    fc.assert(
      fc.property(arbitrarySession, numbers, (session, list) => {
        const start = graphOf(session);
        const end = edited(start, list);
        let state = end;
        while (state.past.length > 0) state = undo(state);
        expect(state.graph).toEqual(start);
        while (state.future.length > 0) state = redo(state);
        expect(state.graph).toEqual(end.graph);
        for (const { label } of end.past) expect(label).toMatch(/^[A-Z].*\S$/);
      }),
      { numRuns: 200 },
    );
  });

  it('end in a graph that its session gives again', () => {
    fc.assert(
      fc.property(arbitrarySession, numbers, (loose, list) => {
        const session = withIds(loose, counter());
        const { graph } = edited(graphOf(session), list);
        const saved = sessionOf(graph, session);
        expect(decode(SESSION, encode(SESSION, saved))).toStrictEqual(saved);
        expect(told(graphOf(saved))).toEqual(told(graph));
        expect(sessionOf(graphOf(saved), saved)).toStrictEqual(saved);
      }),
      { numRuns: 150 },
    );
  });

  it('leave no wire without ends', () => {
    fc.assert(
      fc.property(arbitrarySession, numbers, (session, list) => {
        const { graph } = edited(graphOf(session), list);
        for (const { from, to } of graph.wires.values()) {
          expect(graph.nodes.has(from.node) && graph.nodes.has(to.node)).toBe(true);
        }
      }),
    );
  });
});
