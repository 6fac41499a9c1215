import type ELK from 'elkjs/lib/elk-api.js';
import type { Point } from '../graph.ts';
import { elkLayout } from './elk-layout.ts';
import type { LayoutGraph } from './layout-graph.ts';

/** Lays out; rejects when it cannot. */
export type Layouter = (graph: LayoutGraph) => Promise<ReadonlyMap<string, Point>>;

/** What is used of a Worker. */
export type LayoutThread = Pick<Worker, 'postMessage' | 'onmessage' | 'onerror' | 'terminate'>;

type ElkConstructor = typeof ELK;

/** Bundlers and Node differ in what the default of a CommonJS module is. */
async function loadElk(): Promise<ElkConstructor> {
  const { default: whole } = (await import('elkjs/lib/elk-api.js')) as {
    default: ElkConstructor | { readonly default: ElkConstructor };
  };
  return 'default' in whole ? whole.default : whole;
}

/** Lays out in a thread that is started for each question and ends with its answer. */
export function threadLayouter(startThread: () => Promise<LayoutThread>): Layouter {
  return async (graph) => {
    const [Elk, thread] = await Promise.all([loadElk(), startThread()]);
    try {
      // The library gets no event for a worker that cannot start, and would wait forever.
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

/** In a worker of this page, which is loaded when it is first needed. */
export const workerLayouter: Layouter = threadLayouter(async () => {
  const { default: url } = await import('elkjs/lib/elk-worker.min.js?url');
  return new Worker(url);
});
