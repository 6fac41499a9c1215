import ELK from 'elkjs/lib/elk.bundled.js';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { graphOf } from '../graph-of.ts';
import type { Graph, Point } from '../graph.ts';
import { arbitrarySession } from '../testing/arbitrary-session.ts';
import { aGraphOf, aModule } from '../testing/small-graph.ts';
import { elkLayout } from './elk-layout.ts';
import { layeredLayout } from './layered-layout.ts';
import { layoutGraphOf, usualSize } from './layout-graph.ts';
import { threadLayouter, type LayoutThread } from './worker-layouter.ts';
import { layoutGraph, placeNew } from './place-graph.ts';

/** The layout library starts slowly on a busy computer. */
const TIMEOUT_MS = 60_000;
const elk = new ELK();
const io = { i: 'double' };
const chain = aGraphOf(
  ['a', 'b', 'c'].map((name) => aModule(name, io, { o: 'double' })),
  { 'a.i': '/in', 'a.o': '/1', 'b.i': '/1', 'b.o': '/2', 'c.i': '/2', 'c.o': '/out' },
);
const ORDER = ['topic:/in', 'module:a', 'module:b', 'module:c', 'topic:/out'];

function expectApart(graph: Graph, places: ReadonlyMap<string, Point>): void {
  const boxes = [...places].map(([id, place]) => ({
    ...place,
    ...usualSize(graph.nodes.get(id)!),
  }));
  boxes.forEach((a, index) => {
    for (const b of boxes.slice(index + 1)) {
      const meet =
        a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
      expect(meet).toBe(false);
    }
  });
}

describe('the simple layout', () => {
  it('goes from left to right', () => {
    const places = layeredLayout(layoutGraphOf(chain, usualSize));
    const xs = ORDER.map((id) => places.get(id)!.x);
    expect(xs).toEqual([...xs].sort((a, b) => a - b));
    expect(new Set(xs).size).toBe(5);
  });

  it('places every node of any graph, none over another, cycles too', () => {
    fc.assert(
      fc.property(arbitrarySession, (session) => {
        const graph = graphOf(session);
        const layout = layoutGraphOf(graph, usualSize);
        const places = layeredLayout(layout);
        expect([...places.keys()].sort()).toEqual(layout.nodes.map(({ id }) => id).sort());
        expectApart(graph, places);
        const placed = placeNew(graph);
        for (const node of placed.nodes.values()) expect(node.position).toBeDefined();
      }),
    );
  });
});

describe('new nodes', () => {
  it('leave the others where they are', () => {
    const node = chain.nodes.get('module:a')!;
    const position = { x: 500, y: 500 };
    const nodes = new Map(chain.nodes).set('module:a', { ...node, position });
    const placed = placeNew({ ...chain, nodes });
    expect(placed.nodes.get('module:a')?.position).toEqual(position);
    expect(placed.nodes.get('module:b')?.position?.y).toBeGreaterThan(500);
    expect(placeNew(placed)).toBe(placed);
  });
});

describe('arranging a graph', { timeout: TIMEOUT_MS }, () => {
  it('goes from left to right, none over another', async () => {
    const places = await layoutGraph(chain, (graph) => elkLayout(elk, graph));
    const xs = ORDER.map((id) => places.get(id)!.x);
    expect(xs).toEqual([...xs].sort((a, b) => a - b));
    expectApart(chain, places);
  });

  it('keeps a few nodes about where they were', async () => {
    const nodes = new Map(
      [...chain.nodes].map(([id, node]) => [id, { ...node, position: { x: 1000, y: 1000 } }]),
    );
    const only = new Set(['module:a', 'module:b']);
    const places = await layoutGraph({ ...chain, nodes }, (graph) => elkLayout(elk, graph), {
      only,
    });
    expect([...places.keys()].sort()).toEqual([...only]);
    expect(Math.abs(places.get('module:a')!.y - 1000)).toBeLessThan(40);
  });

  it('is simple when the worker fails', async () => {
    const failing = await layoutGraph(chain, () => Promise.reject(new Error('no worker')));
    expect(failing.size).toBe(5);
    expect(await layoutGraph(aGraphOf([]), () => Promise.reject(new Error('none')))).toEqual(
      new Map(),
    );
  });
});

describe('the thread', { timeout: TIMEOUT_MS }, () => {
  const layout = layoutGraphOf(chain, usualSize);

  it('lays out as the page itself would, and ends', async () => {
    let ended = 0;
    // With a DOM, elkjs exports a worker that runs in the same thread.
    const { default: inPage } = (await import('elkjs/lib/elk-worker.js')) as unknown as {
      default: { readonly Worker: new () => LayoutThread };
    };
    const thread = new inPage.Worker();
    thread.terminate = () => (ended += 1);
    const places = await threadLayouter(() => Promise.resolve(thread))(layout);
    expect(places).toEqual(await elkLayout(elk, layout));
    expect(ended).toBe(1);
  });

  it('says when it cannot start, and ends', async () => {
    let ended = 0;
    const thread: LayoutThread = {
      postMessage: () =>
        queueMicrotask(() => thread.onerror?.call(thread as Worker, {} as ErrorEvent)),
      onmessage: null,
      onerror: null,
      terminate: () => (ended += 1),
    };
    await expect(threadLayouter(() => Promise.resolve(thread))(layout)).rejects.toThrow('worker');
    expect(ended).toBe(1);
  });
});
