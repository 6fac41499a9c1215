import { AssetError, missingSet } from './asset-error.ts';
import { ASSET_LIMITS, readManifest, type AssetFile } from './asset-manifest.ts';
import type { AssetSource } from './asset-source.ts';

/** Path of all asset sets on a master. [PM-92] */
export const ASSETS_PATH = '/asset-sets';
/** A connection that gives nothing for so long is given up, milliseconds. */
const STALL_MS = 20_000;

/** Path of a file of a set. The hash makes it a file that never changes. */
export function assetFilePath(name: string, { path, sha256 }: Pick<AssetFile, 'path' | 'sha256'>) {
  const parts = path.split('/').map(encodeURIComponent).join('/');
  return `${ASSETS_PATH}/${name}/${sha256}/${parts}`;
}

/** Path of the manifest of a set. */
export const manifestPath = (name: string): string => `${ASSETS_PATH}/${name}/manifest.json`;

/**
 * Asset sets of a master, over HTTP.
 *
 * @param origin of the master, such as `https://host:8443`; a function is called for each file: a client may go on at
 * another master
 */
export function createHttpAssets(origin: string | URL | (() => string | URL)): AssetSource {
  const originOf = typeof origin === 'function' ? origin : () => origin;
  const get = async (
    name: string,
    path: string,
    limitBytes: number,
    signal: AbortSignal,
    onBytes: (bytes: number) => void,
    isFresh = false,
  ): Promise<Uint8Array<ArrayBuffer>> => {
    signal.throwIfAborted();
    const stall = new AbortController();
    const stop = (): void => stall.abort();
    let timer: ReturnType<typeof setTimeout> | undefined;
    const wait = (): void => {
      clearTimeout(timer);
      timer = setTimeout(stop, STALL_MS);
    };
    signal.addEventListener('abort', stop, { once: true });
    try {
      wait();
      const response = await fetch(new URL(path, originOf()), {
        signal: stall.signal,
        ...(isFresh && { cache: 'reload' }),
      });
      if (response.status === 404) throw missingSet(name);
      if (!response.ok || response.body === null)
        throw unreachable(name, `the master answers with status ${response.status}`);
      const parts: Uint8Array[] = [];
      let bytes = 0;
      for (const reader = response.body.getReader(); ;) {
        const { done, value } = await reader.read();
        if (done) break;
        wait();
        bytes += value.length;
        parts.push(value);
        if (bytes > limitBytes) {
          await reader.cancel();
          break; // longer than the manifest says, which is found out
        }
        onBytes(value.length);
      }
      return joined(parts);
    } catch (cause) {
      signal.throwIfAborted();
      if (cause instanceof AssetError) throw cause;
      if (stall.signal.aborted)
        throw unreachable(name, `the master sent nothing for ${STALL_MS / 1000} s`);
      throw unreachable(name, cause instanceof Error ? cause.message : String(cause));
    } finally {
      clearTimeout(timer);
      signal.removeEventListener('abort', stop);
    }
  };
  return {
    async manifest(name, signal) {
      const bytes = await get(
        name,
        manifestPath(name),
        ASSET_LIMITS.manifestBytes,
        signal,
        () => {},
      );
      return readManifest(parsed(name, bytes), name);
    },
    read: (name, file, signal, onBytes, isFresh) =>
      get(name, assetFilePath(name, file), file.bytes, signal, onBytes, isFresh),
  };
}

function parsed(name: string, bytes: Uint8Array): unknown {
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw new AssetError('damaged', `The manifest of the asset set ${name} is not valid JSON.`);
  }
}

function unreachable(name: string, why: string): AssetError {
  return new AssetError('unreachable', `The asset set ${name} could not be loaded: ${why}.`);
}

function joined(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
