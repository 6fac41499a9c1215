import { sha256 } from '@noble/hashes/sha2.js';
import { bytesToHex } from '@noble/hashes/utils.js';
import { missingSet } from '../assets/asset-error.ts';
import { readManifest, type AssetManifest } from '../assets/asset-manifest.ts';
import type { AssetSource } from '../assets/asset-source.ts';
import type { LoadedAssets } from '../assets/asset-store.ts';

/** Files by path, as text. */
export type AssetTexts = Readonly<Record<string, string>>;

const bytesOf = (text: string): Uint8Array<ArrayBuffer> => new TextEncoder().encode(text);

/** The manifest of files. */
export function manifestOf(name: string, texts: AssetTexts, library?: string): AssetManifest {
  const files = Object.entries(texts).map(([path, text]) => {
    const bytes = bytesOf(text);
    return { path, bytes: bytes.length, sha256: bytesToHex(sha256(bytes)) };
  });
  return readManifest({ name, library, files }, name);
}

/** A set that is loaded. */
export function loadedAssets(name: string, texts: AssetTexts, library?: string): LoadedAssets {
  const files = Object.fromEntries(
    Object.entries(texts).map(([path, text]) => [path, bytesOf(text)]),
  );
  return { name, key: `${name} ${JSON.stringify(texts)}`, library, files };
}

/** Asset sets in memory. */
export class FakeAssets implements AssetSource {
  readonly sets = new Map<string, { manifest: AssetManifest; texts: AssetTexts }>();
  /** Files that were read, as `set/path`. */
  readonly reads: string[] = [];
  /** Resolves before a file is given. */
  pause: Promise<void> = Promise.resolve();

  add(name: string, texts: AssetTexts, library?: string): void {
    this.sets.set(name, { manifest: manifestOf(name, texts, library), texts });
  }

  async manifest(name: string): Promise<AssetManifest> {
    const set = this.sets.get(name);
    if (set === undefined) throw missingSet(name);
    return set.manifest;
  }

  async read(
    name: string,
    { path }: { path: string },
    signal: AbortSignal,
    onBytes: (bytes: number) => void,
    _isFresh?: boolean,
  ): Promise<Uint8Array<ArrayBuffer>> {
    this.reads.push(`${name}/${path}`);
    await this.pause;
    signal.throwIfAborted();
    const bytes = bytesOf(this.sets.get(name)!.texts[path]!);
    onBytes(bytes.length);
    return bytes;
  }
}
