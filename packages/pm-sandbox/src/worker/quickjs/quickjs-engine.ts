import type { Engine } from '../engine.ts';
import { loadQuickJs } from './load-quickjs.ts';
import { QuickJsInstance, type QuickJsOptions } from './quickjs-instance.ts';

/**
 * Runs sandboxed code: an engine without files, network, timers and objects of its host. Each
 * instance has an engine in memory of its own. Same in Node and browsers. [PM-52]
 */
export async function createQuickJsEngine(options: QuickJsOptions): Promise<Engine> {
  const makeCopy = await loadQuickJs();
  return {
    async open(request, hooks) {
      return new QuickJsInstance(
        await makeCopy(request.limits.memoryBytes),
        request,
        hooks,
        options,
      );
    },
  };
}
