import variant from '@jitl/quickjs-singlefile-mjs-release-sync';
import {
  newQuickJSWASMModuleFromVariant,
  newVariant,
  type QuickJSWASMModule,
} from 'quickjs-emscripten-core';

/**
 * Makes a function that yields new copies of the engine, each with memory of its own: what breaks
 * one, or is left behind in it, does not touch another, and it is freed as a whole. The engine is
 * compiled once; a copy takes a few milliseconds and a quarter of a megabyte.
 */
export async function loadQuickJs(): Promise<() => Promise<QuickJSWASMModule>> {
  const copied = newVariant(variant, { wasmModule: await compiledOnce() });
  return () => newQuickJSWASMModuleFromVariant(copied);
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
