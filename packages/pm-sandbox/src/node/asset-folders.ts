import { createHash } from 'node:crypto';
import { createReadStream } from 'node:fs';
import { readdir, readFile, stat } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { pipeline } from 'node:stream/promises';
import { AssetError, missingSet } from '../assets/asset-error.ts';
import {
  ASSET_LIMITS,
  isAssetName,
  isAssetPath,
  readManifest,
  totalBytes,
  type AssetFile,
  type AssetManifest,
} from '../assets/asset-manifest.ts';
import type { AssetSource } from '../assets/asset-source.ts';

const MANIFEST = 'manifest.json';
/** Of more files the hashes are looked at again. */
const MAX_VERIFIED = 1024;

/** A manifest that is made from files, and what tells that they are others by now. */
interface Made {
  readonly manifest: Promise<AssetManifest>;
  readonly stamp: string;
}

/**
 * Asset sets on disk: each is a folder with its name. A set without `manifest.json` consists of the files
 * that are in its folder. [PM-93]
 */
export class AssetFolders implements AssetSource {
  readonly #folders: readonly string[];
  readonly #made = new Map<string, Made>();
  /** Files that were found to be what their manifests say. */
  readonly #verified = new Set<string>();

  /** @param folders that hold sets; of two sets with one name that of the later folder counts */
  constructor(folders: readonly string[]) {
    this.#folders = [...folders].reverse();
  }

  async manifest(name: string): Promise<AssetManifest> {
    return (await this.#find(name)).manifest;
  }

  /** Names of the folders that can be asked for. */
  async names(): Promise<string[]> {
    const lists = this.#folders.map((folder) =>
      readdir(folder, { withFileTypes: true }).catch(() => []),
    );
    const entries = (await Promise.all(lists)).flat();
    const names = entries.flatMap((entry) =>
      entry.isDirectory() && isAssetName(entry.name) ? [entry.name] : [],
    );
    return [...new Set(names)];
  }

  /**
   * Returns the folder that contains a set.
   * @throws AssetError when there is no such set
   */
  async parentOf(name: string): Promise<string> {
    return dirname((await this.#find(name)).folder);
  }

  async read(
    name: string,
    file: AssetFile,
    signal: AbortSignal,
    onBytes: (bytes: number) => void,
  ): Promise<Uint8Array<ArrayBuffer>> {
    const path = await this.pathOf(name, file.path);
    try {
      const bytes = new Uint8Array(await readFile(path, { signal }));
      onBytes(bytes.length);
      return bytes;
    } catch (cause) {
      signal.throwIfAborted();
      throw unreadable(name, file.path, cause);
    }
  }

  /**
   * Returns the path of a file of a set.
   * @throws AssetError when the set has no such file
   */
  async pathOf(name: string, path: string): Promise<string> {
    const { folder, manifest } = await this.#find(name);
    if (manifest.files.some((file) => file.path === path)) return join(folder, path);
    throw new AssetError('missing', `The asset set ${name} has no file ${path}.`);
  }

  async #find(name: string): Promise<{ folder: string; manifest: AssetManifest }> {
    if (!isAssetName(name)) throw missingSet(name);
    for (const parent of this.#folders) {
      const folder = join(parent, name);
      if (!(await isFolder(folder))) continue;
      const text = await readText(join(folder, MANIFEST), name);
      if (text !== undefined) return { folder, manifest: readManifest(parsed(name, text), name) };
      const files = await listFiles(folder);
      if (files.length > 0) return { folder, manifest: await this.#make(name, folder, files) };
    }
    throw missingSet(name);
  }

  /** Hashed once for all that ask. */
  #make(name: string, folder: string, files: readonly FoundFile[]): Promise<AssetManifest> {
    const stamp = JSON.stringify([folder, files]);
    const known = this.#made.get(name);
    if (known?.stamp === stamp) return known.manifest;
    const manifest = manifestOf(name, folder, files);
    this.#made.set(name, { manifest, stamp });
    manifest.catch(() => {
      if (this.#made.get(name)?.manifest === manifest) this.#made.delete(name);
    });
    return manifest;
  }

  /**
   * Whether a file on disk is what the manifest says; looked at again when its size or time changed.
   * @throws AssetError when it is not, or cannot be read
   */
  async verify(name: string, file: AssetFile): Promise<string> {
    const path = await this.pathOf(name, file.path);
    const { size, mtimeMs } = await stat(path).catch((cause: unknown) => {
      throw unreadable(name, file.path, cause);
    });
    const stamp = JSON.stringify([path, size, mtimeMs, file.sha256]);
    if (this.#verified.has(stamp)) return path;
    if (size !== file.bytes || (await hashOf(name, file.path, path)) !== file.sha256) {
      throw new AssetError(
        'damaged',
        `The file ${file.path} of the asset set ${name} is damaged. Replace the file or delete the set.`,
      );
    }
    if (this.#verified.size >= MAX_VERIFIED) this.#verified.clear();
    this.#verified.add(stamp);
    return path;
  }
}

async function manifestOf(
  name: string,
  folder: string,
  files: readonly FoundFile[],
): Promise<AssetManifest> {
  if (files.length > ASSET_LIMITS.files || totalBytes(files) > ASSET_LIMITS.setBytes) {
    const message = `The folder of the asset set ${name} has more than ${ASSET_LIMITS.files} files or ${ASSET_LIMITS.setBytes} bytes.`;
    throw new AssetError('damaged', message);
  }
  const hashed: AssetFile[] = [];
  for (const { path, bytes } of files) {
    hashed.push({ path, bytes, sha256: await hashOf(name, path, join(folder, path)) });
  }
  return readManifest({ name, files: hashed }, name);
}

interface FoundFile extends Omit<AssetFile, 'sha256'> {
  readonly changedMs: number;
  readonly sha256: '';
}

/** Files of a folder and of those in it, by path; what cannot be part of a set is left out. */
async function listFiles(folder: string): Promise<FoundFile[]> {
  const found: FoundFile[] = [];
  const entries = await readdir(folder, { withFileTypes: true, recursive: true });
  for (const entry of entries) {
    if (!entry.isFile() || found.length > ASSET_LIMITS.files) continue;
    const full = join(entry.parentPath, entry.name);
    const path = full.slice(folder.length + 1).replaceAll('\\', '/');
    if (!isAssetPath(path)) continue;
    const { size, mtimeMs } = await stat(full);
    found.push({ path, bytes: size, changedMs: mtimeMs, sha256: '' });
  }
  return found.sort((a, b) => (a.path < b.path ? -1 : 1));
}

async function hashOf(name: string, path: string, file: string): Promise<string> {
  const hash = createHash('sha256');
  try {
    await pipeline(createReadStream(file), hash);
  } catch (cause) {
    throw unreadable(name, path, cause);
  }
  return hash.digest('hex');
}

async function isFolder(path: string): Promise<boolean> {
  return await stat(path).then(
    (found) => found.isDirectory(),
    () => false,
  );
}

/** @returns undefined when there is no such file */
async function readText(path: string, name: string): Promise<string | undefined> {
  try {
    const { size } = await stat(path);
    if (size > ASSET_LIMITS.manifestBytes)
      throw new AssetError('damaged', `The manifest of the asset set ${name} is too large.`);
    return await readFile(path, 'utf8');
  } catch (cause) {
    if (cause instanceof AssetError) throw cause;
    if ((cause as NodeJS.ErrnoException).code === 'ENOENT') return undefined;
    throw unreadable(name, MANIFEST, cause);
  }
}

function parsed(name: string, text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    throw new AssetError('damaged', `The manifest of the asset set ${name} is not valid JSON.`);
  }
}

function unreadable(name: string, path: string, cause: unknown): AssetError {
  const why = cause instanceof Error ? cause.message : String(cause);
  return new AssetError(
    'unreachable',
    `The file ${path} of the asset set ${name} cannot be read: ${why}.`,
  );
}
