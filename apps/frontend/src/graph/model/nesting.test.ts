import { describe, expect, it } from 'vitest';
import { mergeGraphs } from './changes/merge-graphs.ts';
import { applyCommand } from './commands/apply-command.ts';
import type { GraphCommand } from './commands/graph-command.ts';
import { perform, startEditing, undo } from './commands/edit-state.ts';
import { graphOf } from './graph-of.ts';
import type { Graph } from './graph.ts';
import { frameNode } from './make-node.ts';
import { sessionOf } from './session-of.ts';
import { aModule, aSessionOf } from './testing/small-graph.ts';
import { copyText, paste } from './selection/clipboard.ts';
import { dropNodes } from './selection/drop-nodes.ts';
import { frameAround, resizeFrame } from './selection/frames.ts';
import { framesAround, withContents } from './nesting.ts';

const session = aSessionOf([aModule('a'), aModule('b')]);
const run = (graph: Graph, ...commands: readonly GraphCommand[]): Graph =>
  commands.reduce((before, command) => applyCommand(before, command).graph, graph);
const area = (id: string, x: number, width: number) => ({ id, x, y: 0, width, height: width });
const OUTER = area('frame:outer', 0, 1000);
const INNER = area('frame:inner', 100, 400);
const A = { id: 'module:a', x: 200, y: 200, width: 100, height: 50 };
const framed = (id: string, { x, y, width, height }: typeof OUTER, frame?: string) =>
  frameNode(id, '', { position: { x, y }, size: { width, height }, frame });
/** A module in a frame in a frame; `b` is outside. */
const nested = run(
  graphOf(session),
  {
    kind: 'add',
    nodes: [framed('frame:outer', OUTER), framed('frame:inner', INNER, 'frame:outer')],
  },
  { kind: 'setFrame', nodes: ['module:a'], frame: 'frame:inner' },
  { kind: 'move', positions: new Map([['module:a', { x: 200, y: 200 }]]) },
);
const frameOf = (graph: Graph, id: string): string | undefined => graph.nodes.get(id)?.frame;
const drop = { by: { x: 0, y: 0 }, isDetached: false, on: undefined };

describe('frames in frames', () => {
  it('move with the outer one, and what is in them', () => {
    expect(framesAround(nested.nodes, 'module:a')).toEqual(['frame:inner', 'frame:outer']);
    expect([...withContents(nested, ['frame:outer'])].sort()).toEqual([
      'frame:inner',
      'frame:outer',
      'module:a',
    ]);
    const moved = run(nested, {
      kind: 'move',
      positions: new Map([['frame:outer', { x: 10, y: 20 }]]),
    });
    expect(moved.nodes.get('frame:inner')?.position).toEqual({ x: 110, y: 20 });
    expect(moved.nodes.get('module:a')?.position).toEqual({ x: 210, y: 220 });
  });

  it('stay where they are when the inner one was given a place of its own', () => {
    const positions = new Map([
      ['frame:outer', { x: 10, y: 20 }],
      ['frame:inner', { x: 100, y: 0 }],
    ]);
    const moved = run(nested, { kind: 'move', positions });
    expect(moved.nodes.get('module:a')?.position).toEqual({ x: 200, y: 200 });
  });

  it('are joined and left by dragging, larger ones only', () => {
    const away = { ...INNER, x: 3000 };
    const boxes = [away, { ...A, x: 3100 }];
    const left = run(nested, dropNodes(nested, { ...drop, boxes, frames: [OUTER, away] }));
    expect([frameOf(left, 'frame:inner'), frameOf(left, 'module:a')]).toEqual([
      undefined,
      'frame:inner',
    ]);
    const back = run(left, dropNodes(left, { ...drop, boxes: [INNER, A], frames: [OUTER, INNER] }));
    expect(frameOf(back, 'frame:inner')).toBe('frame:outer');
    const over = { ...OUTER, x: -200 };
    const dropped = dropNodes(left, { ...drop, boxes: [over], frames: [over, INNER] });
    expect(frameOf(run(left, dropped), 'frame:outer')).toBeUndefined();
  });

  it('never contain themselves', () => {
    const same = run(
      nested,
      { kind: 'setFrame', nodes: ['frame:outer'], frame: 'frame:inner' },
      { kind: 'setFrame', nodes: ['frame:outer'], frame: 'frame:outer' },
    );
    expect(same).toEqual(nested);
    const apart = run(nested, { kind: 'setFrame', nodes: ['frame:inner'], frame: undefined });
    const other = run(apart, { kind: 'setFrame', nodes: ['frame:outer'], frame: 'frame:inner' });
    const { graph } = mergeGraphs(apart, nested, other);
    expect(framesAround(graph.nodes, 'frame:inner').length).toBeLessThan(2);
    expect(framesAround(graph.nodes, 'frame:outer').length).toBeLessThan(2);
    const loops = [frameOf(graph, 'frame:inner'), frameOf(graph, 'frame:outer')];
    expect(loops.filter((one) => one !== undefined)).toHaveLength(1);
  });

  it('leave what is in them to the frame around, and come back with undo', () => {
    const state = perform(startEditing(nested), { kind: 'ungroup', frame: 'frame:inner' });
    expect(frameOf(state.graph, 'module:a')).toBe('frame:outer');
    expect(undo(state).graph).toEqual(nested);
    const none = run(nested, { kind: 'remove', nodes: ['frame:inner', 'frame:outer'] });
    expect(frameOf(none, 'module:a')).toBeUndefined();
  });

  it('are made around frames, and inside the one that all lie in', () => {
    const boxes = [INNER, A];
    const made = run(nested, frameAround(nested, boxes, 'frame:new'));
    expect(framesAround(made.nodes, 'module:a')).toEqual([
      'frame:inner',
      'frame:new',
      'frame:outer',
    ]);
    const b = { ...A, id: 'module:b', x: 5000 };
    const wide = run(nested, frameAround(nested, [A, b], 'frame:new'));
    expect(frameOf(wide, 'frame:new')).toBeUndefined();
  });

  it('take in and give back what lies in them when they are resized', () => {
    const inner = nested.nodes.get('frame:inner');
    if (inner?.kind !== 'frame') throw new Error('no frame');
    const boxes = [OUTER, INNER, A, { ...A, id: 'module:b', x: 600 }];
    const small = run(nested, resizeFrame(nested, inner, { ...INNER, width: 50 }, boxes));
    expect(frameOf(small, 'module:a')).toBe('frame:outer');
    const wide = run(nested, resizeFrame(nested, inner, { ...INNER, width: 700 }, boxes));
    expect([frameOf(wide, 'module:b'), frameOf(wide, 'frame:outer')]).toEqual([
      'frame:inner',
      undefined,
    ]);
  });

  it('are saved, and copied', () => {
    const saved = graphOf(sessionOf(nested, session));
    expect(framesAround(saved.nodes, 'module:a')).toEqual(['frame:inner', 'frame:outer']);
    let count = 0;
    const uuid = (): string => `new${(count += 1)}`;
    const pasted = paste(nested, copyText(nested, ['frame:outer']), { uuid });
    if (pasted.kind !== 'nodes') throw new Error('nothing was pasted');
    const both = run(nested, pasted.command);
    const copy = pasted.ids.find((id) => id.startsWith('module:'))!;
    const around = framesAround(both.nodes, copy);
    expect(around).toHaveLength(2);
    expect(around).not.toContain('frame:outer');
  });
});
