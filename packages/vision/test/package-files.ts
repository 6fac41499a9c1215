import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import type { Files } from '../src/tensorflow/memory-platform.ts';

const { resolve } = createRequire(import.meta.url);

/** Reads files of an installed package, by the last part of their names. */
export function packageFiles(anchor: string, folder: string, names: readonly string[]): Files {
  const base = join(dirname(resolve(anchor)), folder);
  return Object.fromEntries(
    names.map((name) => [name, new Uint8Array(readFileSync(join(base, name)))]),
  );
}

/** What `createTensorflow` needs. */
export const wasmFiles = (): Files =>
  packageFiles('@tensorflow/tfjs-backend-wasm', '.', ['tfjs-backend-wasm-simd.wasm']);
