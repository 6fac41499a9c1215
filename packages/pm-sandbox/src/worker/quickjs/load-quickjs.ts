import variant from '@jitl/quickjs-singlefile-mjs-release-sync';
import {
  newQuickJSWASMModuleFromVariant,
  newVariant,
  type QuickJSWASMModule,
} from 'quickjs-emscripten-core';

/** A copy of the engine with memory of its own. */
export interface EngineCopy {
  readonly quickJs: QuickJSWASMModule;
  /** Whether it ever wanted more memory than it may have. */
  wasRefusedMemory(): boolean;
}

/** Of WebAssembly. */
const PAGE_BYTES = 65_536;
/** What the engine was compiled to begin with: 16 MiB, of which it touches a quarter of one. */
const INITIAL_PAGES = 256;

/**
 * Makes a function that yields new copies of the engine, each with memory of its own: what breaks
 * one, or is left behind in it, does not touch another, and it is freed as a whole. The engine is
 * compiled once; a copy takes a few milliseconds and a quarter of a megabyte.
 */
export async function loadQuickJs(): Promise<(memoryBytes: number) => Promise<EngineCopy>> {
  const wasmModule = await compiledOnce();
  return async (memoryBytes) => {
    const memory = createMemory(memoryBytes);
    const limited = newVariant(variant, { wasmModule, wasmMemory: memory.wasmMemory });
    return {
      quickJs: await newQuickJSWASMModuleFromVariant(limited),
      wasRefusedMemory: memory.wasRefused,
    };
  };
}

/**
 * Memory that grows to a size and no further; the engine then reports that it is out of memory. The
 * engine's own limit cannot be relied on: compiled to WebAssembly it does not know how big its
 * allocations are, and counts eight bytes for each.
 */
function createMemory(maxBytes: number): {
  readonly wasmMemory: WebAssembly.Memory;
  wasRefused(): boolean;
} {
  const maximum = Math.max(INITIAL_PAGES, Math.floor(maxBytes / PAGE_BYTES));
  const wasmMemory = new WebAssembly.Memory({ initial: INITIAL_PAGES, maximum });
  const grow = wasmMemory.grow.bind(wasmMemory);
  let wasRefused = false;
  wasmMemory.grow = (pages) => {
    try {
      return grow(pages);
    } catch (thrown) {
      wasRefused = true;
      throw thrown;
    }
  };
  return { wasmMemory, wasRefused: () => wasRefused };
}

/** The package holds the engine as text and compiles it each time; the first time tells us the result. */
async function compiledOnce(): Promise<WebAssembly.Module> {
  const { instantiate } = WebAssembly;
  let compiled: WebAssembly.Module | undefined;
  const noteModule = async (
    source: BufferSource | WebAssembly.Module,
    imports?: WebAssembly.Imports,
  ): Promise<WebAssembly.WebAssemblyInstantiatedSource> => {
    const module =
      source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
    compiled = module;
    return { module, instance: await instantiate(module, imports) };
  };
  WebAssembly.instantiate = noteModule as typeof instantiate;
  try {
    await newQuickJSWASMModuleFromVariant(variant);
  } finally {
    WebAssembly.instantiate = instantiate;
  }
  if (compiled === undefined) throw new Error('the engine was not compiled');
  return compiled;
}
