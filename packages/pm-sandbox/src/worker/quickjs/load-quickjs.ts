import variant from '@jitl/quickjs-singlefile-mjs-release-sync';
import {
  newQuickJSWASMModuleFromVariant,
  newVariant,
  type QuickJSWASMModule,
} from 'quickjs-emscripten-core';
import { PAGE_BYTES, type MemoryShortage } from '../memory-account.ts';
import { INITIAL_PAGES, UNTOUCHED_PAGES } from './engine-pages.ts';

const IMPORTS = 2;
const HEADER_BYTES = 8;
const MEMORY = 2;

/**
 * Lets a compiled program begin with fewer pages of the memory that it imports. It is compiled to ask
 * for 16 MiB, most of which it never touches: what is asked for is what can be counted.
 *
 * @returns undefined when the program imports no memory, or the number does not fit into its place
 */
function withInitialPages(program: Uint8Array, pages: number): Uint8Array | undefined {
  const reader = new Reader(program, HEADER_BYTES);
  while (reader.at < program.length) {
    const section = reader.byte();
    const end = reader.number() + reader.at;
    if (section !== IMPORTS) {
      reader.at = end;
      continue;
    }
    for (let left = reader.number(); left > 0; left--) {
      reader.skipName();
      reader.skipName();
      const kind = reader.byte();
      if (kind === MEMORY) return withNumberAt(program, reader.at + 1, pages);
      // Functions have a type; this program imports nothing else before its memory.
      if (kind !== 0) return undefined;
      reader.number();
    }
    return undefined;
  }
  return undefined;
}

/** Writes a number over another one, as long as that is. */
function withNumberAt(program: Uint8Array, at: number, value: number): Uint8Array | undefined {
  const reader = new Reader(program, at);
  reader.number();
  const length = reader.at - at;
  if (value >= 2 ** (7 * length)) return undefined;
  const changed = program.slice();
  for (let i = 0; i < length; i++) {
    const more = i < length - 1 ? 0x80 : 0;
    changed[at + i] = ((value >>> (7 * i)) & 0x7f) | more;
  }
  return changed;
}

class Reader {
  readonly #bytes: Uint8Array;
  at: number;

  constructor(bytes: Uint8Array, at: number) {
    this.#bytes = bytes;
    this.at = at;
  }

  byte(): number {
    return this.#bytes[this.at++] ?? 0;
  }

  /** LEB128. */
  number(): number {
    let value = 0;
    for (let factor = 1; ; factor *= 128) {
      const byte = this.byte();
      value += (byte & 0x7f) * factor;
      if (byte < 0x80) return value;
    }
  }

  skipName(): void {
    const length = this.number();
    this.at += length;
  }
}

/** A copy of the engine with memory of its own. */
export interface EngineCopy {
  readonly quickJs: QuickJSWASMModule;
  /** Bytes that it has of the memory of the machine, as far as they count. */
  memoryBytes(): number;
  /** Why it did not get memory that it wanted: it may have no more (`own`), or there is none left. */
  refusedMemory(): 'own' | MemoryShortage | undefined;
  /** It is not used any more. */
  release(): void;
}

/** Memory budget of an engine. */
export interface EngineMemory {
  /** @returns whose memory does not suffice */
  take(pages: number): MemoryShortage | undefined;
  give(pages: number): void;
}

/** There is no memory left to begin with. */
export class NoMemoryError extends Error {
  readonly shortage: MemoryShortage;

  constructor(shortage: MemoryShortage) {
    super('no memory is left');
    this.name = 'NoMemoryError';
    this.shortage = shortage;
  }
}

/**
 * Makes a function that yields new copies of the engine, each with memory of its own: what breaks
 * one, or is left behind in it, does not touch another, and it is freed as a whole. The engine is
 * compiled once; a copy takes a few milliseconds and a third of a megabyte.
 * The returned function throws `NoMemoryError`.
 */
export async function loadQuickJs(): Promise<
  (memoryBytes: number, from: EngineMemory) => Promise<EngineCopy>
> {
  const wasmModule = await compiledOnce();
  return async (memoryBytes, from) => {
    const memory = createMemory(memoryBytes, from);
    const limited = newVariant(variant, { wasmModule, wasmMemory: memory.wasmMemory });
    try {
      const quickJs = await newQuickJSWASMModuleFromVariant(limited);
      return { quickJs, ...memory };
    } catch (thrown) {
      memory.release();
      throw thrown;
    }
  };
}

/**
 * Memory that grows to a size and no further, and only as long as there is some; the engine then
 * reports that it is out of memory. The engine's own limit cannot be relied on: compiled to
 * WebAssembly it does not know how big its allocations are, and counts eight bytes for each.
 */
function createMemory(
  maxBytes: number,
  from: EngineMemory,
): Omit<EngineCopy, 'quickJs'> & { readonly wasmMemory: WebAssembly.Memory } {
  const maximum = Math.max(INITIAL_PAGES, Math.floor(maxBytes / PAGE_BYTES));
  let pages = INITIAL_PAGES - UNTOUCHED_PAGES;
  const shortage = from.take(pages);
  if (shortage !== undefined) throw new NoMemoryError(shortage);
  const wasmMemory = new WebAssembly.Memory({ initial: INITIAL_PAGES, maximum });
  const grow = wasmMemory.grow.bind(wasmMemory);
  let refused: ReturnType<EngineCopy['refusedMemory']>;
  let isReleased = false;
  wasmMemory.grow = (more) => {
    const has = wasmMemory.buffer.byteLength / PAGE_BYTES;
    const short = has + more > maximum ? 'own' : from.take(more);
    if (short !== undefined) {
      refused = short;
      throw new RangeError('no memory is left');
    }
    pages += more;
    return grow(more);
  };
  return {
    wasmMemory,
    memoryBytes: () => pages * PAGE_BYTES,
    refusedMemory: () => refused,
    release() {
      if (isReleased) return;
      isReleased = true;
      from.give(pages);
    },
  };
}

/**
 * The package holds the engine as text and compiles it each time; the first time tells us the program,
 * which is changed and compiled once.
 */
async function compiledOnce(): Promise<WebAssembly.Module> {
  const { instantiate } = WebAssembly;
  let compiled: WebAssembly.Module | undefined;
  const noteModule = async (
    source: BufferSource | WebAssembly.Module,
    imports?: WebAssembly.Imports,
  ): Promise<WebAssembly.WebAssemblyInstantiatedSource> => {
    const module =
      source instanceof WebAssembly.Module ? source : await WebAssembly.compile(smaller(source));
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

function smaller(source: BufferSource): BufferSource {
  const bytes = ArrayBuffer.isView(source)
    ? new Uint8Array(source.buffer, source.byteOffset, source.byteLength)
    : new Uint8Array(source);
  const changed = withInitialPages(bytes, INITIAL_PAGES);
  if (changed === undefined) throw new Error('the engine is not what it was expected to be');
  return changed as Uint8Array<ArrayBuffer>;
}
