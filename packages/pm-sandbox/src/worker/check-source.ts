import type { ModuleFault } from '../ports/module-fault.ts';
import type { ModuleSource, SandboxLimits } from '../ports/sandbox.ts';
import type { Engine } from './engine.ts';
import { faultOf, moduleFault } from './module-error.ts';
import { MAX_SOURCE_BYTES } from '../sandbox-limits.ts';

/** Limits of reading a source, which only defines functions. */
const CHECK_LIMITS: SandboxLimits = {
  callTimeoutMs: 400,
  memoryBytes: 64 * 1024 * 1024,
  outputBytes: 0,
};

/** Loads the callbacks without calling them. [PM-2] [PM-57] */
export async function checkSource(
  engine: Engine,
  source: ModuleSource,
): Promise<ModuleFault | undefined> {
  const tooLong = sourceTooLong(source);
  if (tooLong !== undefined) return tooLong;
  const request = {
    source,
    limits: CHECK_LIMITS,
    outputNames: [],
    modules: {},
    assets: {},
    hostLibraries: {},
  };
  try {
    const opened = await engine.open(request, {
      onLog: () => undefined,
      callHost: () => Promise.reject(new Error('nothing is called by a check')),
      loadAssets: () => Promise.reject(new Error('nothing is loaded by a check')),
      onResume: () => undefined,
      onFailure: () => undefined,
    });
    opened.free();
    return undefined;
  } catch (thrown) {
    return faultOf(thrown, '');
  }
}

/** Told by characters, before anything is sent: a character is at least a byte. [PM-57] */
export function sourceTooLong(source: ModuleSource): ModuleFault | undefined {
  const { onCreated, onProcessing, onHalted, onDestroyed } = source;
  const length = [onCreated, onProcessing, onHalted, onDestroyed].reduce(
    (sum, text) => sum + (text?.length ?? 0),
    0,
  );
  if (length <= MAX_SOURCE_BYTES) return undefined;
  const message = `The source of the module has ${length} characters; the limit is ${MAX_SOURCE_BYTES} bytes.`;
  return moduleFault('syntax', '', message);
}
