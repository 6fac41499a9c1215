import { AssetError } from './asset-error.ts';

/** One file of an asset set. */
export interface AssetFile {
  /** Relative to the folder of the set, with slashes. */
  readonly path: string;
  readonly bytes: number;
  /** Hexadecimal. */
  readonly sha256: string;
}

/** Content of an asset set. [PM-90] */
export interface AssetManifest {
  readonly name: string;
  /** Empty when not given, as the next two. */
  readonly version: string;
  /** SPDX expression. */
  readonly licence: string;
  readonly source: string;
  /** Path of the script whose value is put into `state.modules`; the others are put into `state.assets`. */
  readonly library: string | undefined;
  readonly files: readonly AssetFile[];
}

/** Largest numbers of one set: models of detectors have few files of some megabytes. */
export const ASSET_LIMITS = {
  files: 64,
  pathLength: 200,
  setBytes: 256 * 1024 * 1024,
  manifestBytes: 64 * 1024,
} as const;

const NAME = /^[a-z0-9][a-z0-9._-]{0,63}$/;
const SHA256 = /^[0-9a-f]{64}$/;

/** Whether a text can be the name of an asset set: it is a part of paths and addresses. */
export function isAssetName(name: string): boolean {
  return NAME.test(name);
}

/** Whether a path stays in the folder of its set. */
export function isAssetPath(path: string): boolean {
  return (
    path.length <= ASSET_LIMITS.pathLength &&
    path.split('/').every((part) => /^[\w@+ -][\w.@+ -]*$/.test(part)) &&
    path !== '__proto__'
  );
}

/**
 * Reads a manifest.
 *
 * @param name of the set it was asked for
 * @throws AssetError that says what is wrong with it
 */
export function readManifest(value: unknown, name: string): AssetManifest {
  const wrong = (why: string): never => {
    throw new AssetError('damaged', `The manifest of the asset set ${name} ${why}.`);
  };
  const { name: own, version, licence, source, library, files } = isObject(value) ? value : {};
  if (own !== name) wrong(`names another set, ${JSON.stringify(own)?.slice(0, 80)}`);
  if (!Array.isArray(files) || files.length === 0) return wrong('lists no files');
  if (files.length > ASSET_LIMITS.files) wrong(`lists more than ${ASSET_LIMITS.files} files`);
  const read = files.map((file: unknown): AssetFile => {
    const { path, bytes, sha256 } = isObject(file) ? file : {};
    if (typeof path !== 'string' || !isAssetPath(path))
      return wrong('has a file without a valid path');
    if (typeof bytes !== 'number' || !Number.isSafeInteger(bytes) || bytes < 0)
      return wrong(`has no size for ${path}`);
    if (typeof sha256 !== 'string' || !SHA256.test(sha256))
      return wrong(`has no SHA-256 for ${path}`);
    return { path, bytes, sha256 };
  });
  if (new Set(read.map(({ path }) => path)).size < read.length) wrong('lists a file twice');
  if (totalBytes(read) > ASSET_LIMITS.setBytes)
    wrong(`has more than ${ASSET_LIMITS.setBytes} bytes of files`);
  if (library !== undefined && !read.some(({ path }) => path === library))
    wrong('names a library that is not among its files');
  return {
    name,
    version: text(version),
    licence: text(licence),
    source: text(source),
    library: library as string | undefined,
    files: read,
  };
}

export function totalBytes(files: readonly AssetFile[]): number {
  return files.reduce((sum, { bytes }) => sum + bytes, 0);
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null;
}

const text = (value: unknown): string => (typeof value === 'string' ? value.slice(0, 500) : '');
