import type { ModulePhase } from '../../ports/module-fault.ts';
import type { Engine, EngineRequest } from '../engine.ts';
import type { MemoryAccount } from '../memory-account.ts';
import { ModuleError } from '../module-error.ts';
import { loadQuickJs, NoMemoryError, type EngineCopy, type EngineMemory } from './load-quickjs.ts';
import { outOfMemory } from './out-of-memory.ts';
import { QuickJsInstance, type QuickJsOptions } from './quickjs-instance.ts';

const CREATION: ModulePhase = 'onCreated';
const UNCOUNTED: EngineMemory = { take: () => undefined, give: () => undefined };

/**
 * Runs sandboxed code: an engine without files, network, timers and objects of its host. Each
 * instance has an engine in memory of its own. Same in Node and browsers. [PM-52]
 *
 * @param memory where instances take their memory from; without, it is not counted
 */
export async function createQuickJsEngine(
  options: QuickJsOptions,
  memory?: MemoryAccount,
): Promise<Engine> {
  const makeCopy = await loadQuickJs();
  const openCopy = async (request: EngineRequest): Promise<EngineCopy> => {
    try {
      return await makeCopy(request.limits.memoryBytes, memoryOf(request, memory));
    } catch (thrown) {
      if (!(thrown instanceof NoMemoryError)) throw thrown;
      throw new ModuleError(outOfMemory(CREATION, thrown.shortage, request.limits, memory));
    }
  };
  return {
    async open(request, hooks) {
      const copy = await openCopy(request);
      try {
        return new QuickJsInstance(copy, request, hooks, options, memory);
      } catch (thrown) {
        copy.release();
        throw thrown;
      }
    },
  };
}

function memoryOf({ owner }: EngineRequest, memory: MemoryAccount | undefined): EngineMemory {
  if (owner === undefined || memory === undefined) return UNCOUNTED;
  return {
    take: (pages) => memory.take(owner, pages),
    give: (pages) => memory.give(owner, pages),
  };
}
