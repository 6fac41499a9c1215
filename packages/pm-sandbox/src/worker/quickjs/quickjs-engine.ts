import type { QuickJSWASMModule } from 'quickjs-emscripten-core';
import type { Engine } from '../engine.ts';
import { loadQuickJs } from './load-quickjs.ts';
import { QuickJsInstance, type QuickJsOptions } from './quickjs-instance.ts';

/**
 * Runs sandboxed code: an engine without files, network, timers and objects of its host. Each
 * instance has an engine in memory of its own. Same in Node and browsers. [PM-52]
 */
export function createQuickJsEngine(options: QuickJsOptions): Engine {
  let loaded: Promise<() => Promise<QuickJSWASMModule>> | undefined;
  return {
    async open(request, hooks) {
      loaded ??= loadQuickJs();
      const makeCopy = await loaded;
      return new QuickJsInstance(await makeCopy(), request, hooks, options);
    },
  };
}
