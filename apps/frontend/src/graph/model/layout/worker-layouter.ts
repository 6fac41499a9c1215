import type ELK from 'elkjs/lib/elk-api.js';
import type { Point } from '../graph.ts';
import { elkLayout } from './elk-layout.ts';
import type { LayoutGraph } from './layout-graph.ts';

/** Lays out a graph; rejects on failure. */
export type Layouter = (graph: LayoutGraph) => Promise<ReadonlyMap<string, Point>>;

/** The part of `Worker` that is used. */
export type LayoutThread = Pick<Worker, 'postMessage' | 'onmessage' | 'onerror' | 'terminate'>;

type ElkConstructor = typeof ELK;

/** Bundlers and Node.js disagree about the default export of a CommonJS module. */
async function loadElk(): Promise<ElkConstructor> {
  const { default: whole } = (await import('elkjs/lib/elk-api.js')) as {
    default: ElkConstructor | { readonly default: ElkConstructor };
  };
  return 'default' in whole ? whole.default : whole;
}

/** Starts a thread for each layout, and terminates it afterwards. */
export function threadLayouter(startThread: () => Promise<LayoutThread>): Layouter {
  return async (graph) => {
    const [Elk, thread] = await Promise.all([loadElk(), startThread()]);
    try {
      // elkjs does not notice a worker that cannot start, and would wait forever.
      const failed = new Promise<never>((_resolve, reject) => {
        thread.onerror = () => reject(new Error('The layout could not be computed in a worker.'));
      });
      const elk = new Elk({ workerFactory: () => thread as Worker });
      return await Promise.race([elkLayout(elk, graph), failed]);
    } finally {
      thread.terminate();
    }
  };
}

/** Lays out in a web worker, which is loaded on first use. */
export const workerLayouter: Layouter = threadLayouter(async () => {
  const { default: url } = await import('elkjs/lib/elk-worker.min.js?url');
  return new Worker(url);
});
