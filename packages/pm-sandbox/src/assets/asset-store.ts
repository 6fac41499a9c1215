import { sha256 } from '@noble/hashes/sha2.js';
import { bytesToHex } from '@noble/hashes/utils.js';
import { AssetError, missingSet } from './asset-error.ts';
import { isAssetName, totalBytes, type AssetFile, type AssetManifest } from './asset-manifest.ts';
import type { AssetSource } from './asset-source.ts';

/** An asset set with its bytes, which nobody may change. */
export interface LoadedAssets {
  readonly name: string;
  /** The same for the same content. */
  readonly key: string;
  readonly library: string | undefined;
  readonly files: Readonly<Record<string, Uint8Array<ArrayBuffer>>>;
}

/** Progress of loading. */
export interface AssetProgress {
  readonly name: string;
  readonly loadedBytes: number;
  readonly totalBytes: number;
}

/** Gives modules their asset sets. */
export interface AssetStore {
  /**
   * Loads what is not there yet and verifies it. The order is that of the names.
   * @throws AssetError; the reason of the signal when it ends first
   */
  load(
    names: readonly string[],
    signal: AbortSignal,
    onProgress: (progress: AssetProgress) => void,
  ): Promise<LoadedAssets[]>;
}

/** Bytes that stay in memory for the next module. */
const KEPT_BYTES = 128 * 1024 * 1024;

interface Kept {
  readonly assets: LoadedAssets;
  readonly bytes: number;
}

/** One that waits for a load. */
interface Waiter {
  onProgress(progress: AssetProgress): void;
}

/** A load under way, and who waits for it. */
interface Loading {
  readonly promise: Promise<LoadedAssets>;
  readonly abort: AbortController;
  readonly waiters: Set<Waiter>;
}

/**
 * Loads each set once for all that wait for it, verifies it, and keeps those used last. A load ends when
 * nobody waits for it any more.
 */
export function createAssetStore(source: AssetSource, keptBytes = KEPT_BYTES): AssetStore {
  return new KeepingStore(source, keptBytes);
}

class KeepingStore implements AssetStore {
  readonly #source: AssetSource;
  readonly #keptBytes: number;
  /** By the key of their content, least lately used first. */
  readonly #kept = new Map<string, Kept>();
  readonly #loading = new Map<string, Loading>();

  constructor(source: AssetSource, keptBytes: number) {
    this.#source = source;
    this.#keptBytes = keptBytes;
  }

  async load(
    names: readonly string[],
    signal: AbortSignal,
    onProgress: (progress: AssetProgress) => void,
  ): Promise<LoadedAssets[]> {
    const sets: LoadedAssets[] = [];
    for (const name of names) sets.push(await this.#loadOne(name, signal, onProgress));
    return sets;
  }

  async #loadOne(
    name: string,
    signal: AbortSignal,
    onProgress: (progress: AssetProgress) => void,
  ): Promise<LoadedAssets> {
    signal.throwIfAborted();
    if (!isAssetName(name)) throw missingSet(name);
    const loading = this.#loading.get(name) ?? this.#begin(name);
    const waiter = { onProgress };
    loading.waiters.add(waiter);
    try {
      return await untilAborted(loading.promise, signal);
    } finally {
      loading.waiters.delete(waiter);
      if (loading.waiters.size === 0) {
        this.#end(name, loading.abort);
        loading.abort.abort(signal.reason);
      }
    }
  }

  #begin(name: string): Loading {
    const abort = new AbortController();
    const waiters: Loading['waiters'] = new Set();
    const promise = this.#read(name, abort.signal, (progress) => {
      for (const waiter of waiters) waiter.onProgress(progress);
    }).finally(() => this.#end(name, abort));
    // Whoever waits is told; nobody may wait any more.
    promise.catch(() => undefined);
    const loading = { promise, abort, waiters };
    this.#loading.set(name, loading);
    return loading;
  }

  /** The next caller starts again. */
  #end(name: string, abort: AbortController): void {
    if (this.#loading.get(name)?.abort === abort) this.#loading.delete(name);
  }

  async #read(
    name: string,
    signal: AbortSignal,
    onProgress: (progress: AssetProgress) => void,
  ): Promise<LoadedAssets> {
    // Asked each time: files in the data directory may be others by now.
    const manifest = await this.#source.manifest(name, signal);
    const key = keyOf(manifest);
    const kept = this.#kept.get(key);
    if (kept !== undefined) {
      this.#keep(key, kept);
      return kept.assets;
    }
    const bytes = totalBytes(manifest.files);
    let loadedBytes = 0;
    const files = new Map<string, Uint8Array<ArrayBuffer>>();
    for (const file of manifest.files) {
      const read = async (isFresh: boolean): Promise<Uint8Array<ArrayBuffer>> => {
        const before = loadedBytes;
        const content = await this.#source.read(
          name,
          file,
          signal,
          (more) => {
            loadedBytes += more;
            onProgress({ name, loadedBytes, totalBytes: bytes });
          },
          isFresh,
        );
        signal.throwIfAborted();
        loadedBytes = before + file.bytes;
        return content;
      };
      let content = await read(false);
      if (damageOf(file, content) !== undefined) {
        loadedBytes -= file.bytes;
        content = await read(true);
      }
      const damage = damageOf(file, content);
      if (damage !== undefined) throw damaged(name, file, damage);
      files.set(file.path, content);
    }
    const { library } = manifest;
    const assets = { name, key, library, files: Object.fromEntries(files) };
    this.#keep(key, { assets, bytes });
    return assets;
  }

  #keep(key: string, kept: Kept): void {
    this.#kept.delete(key);
    this.#kept.set(key, kept);
    let sum = 0;
    for (const [other, { bytes }] of [...this.#kept].reverse()) {
      sum += bytes;
      if (sum > this.#keptBytes) this.#kept.delete(other);
    }
  }
}

function keyOf({ name, library = '', files }: AssetManifest): string {
  const text = JSON.stringify([name, library, files.map((file) => [file.path, file.sha256])]);
  return bytesToHex(sha256(new TextEncoder().encode(text)));
}

/** Returns the difference of the bytes of a file from the manifest; undefined without one. */
function damageOf({ bytes, sha256: expected }: AssetFile, content: Uint8Array): string | undefined {
  if (content.length !== bytes) return `it has ${content.length} bytes instead of ${bytes}`;
  const isEqual = bytesToHex(sha256(content)) === expected;
  return isEqual ? undefined : 'its SHA-256 differs from the manifest';
}

function damaged(name: string, { path }: AssetFile, why: string): AssetError {
  return new AssetError(
    'damaged',
    `The file ${path} of the asset set ${name} is damaged: ${why}. Replace the file or delete the set.`,
  );
}

function untilAborted<T>(promise: Promise<T>, signal: AbortSignal): Promise<T> {
  return new Promise((resolve, reject) => {
    const stop = (): void => reject(signal.reason as Error);
    signal.addEventListener('abort', stop, { once: true });
    promise.then(resolve, reject).finally(() => signal.removeEventListener('abort', stop));
  });
}
