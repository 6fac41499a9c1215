import { join } from 'node:path';
import { AssetError } from '@ubii/pm-sandbox';
import type { AssetFolders } from '@ubii/pm-sandbox/node';
import { AssetSetState, type AssetSet } from '@ubii/proto';
import { modelAddress, modelBytes, type KnownModel } from './catalogue.ts';

/** Folders that may contain an asset set. */
export interface AssetSetPlaces {
  readonly assets: AssetFolders;
  /** `models/` of the data directory. */
  readonly folder: string;
  readonly mirror: string | undefined;
  /** Catalogue entry of the model; undefined when it cannot be downloaded. */
  readonly model: KnownModel | undefined;
}

/** Names of the sets on disk and of those that can be downloaded, in order. */
export async function assetSetNames(
  assets: AssetFolders,
  models: readonly KnownModel[],
): Promise<string[]> {
  return [...new Set([...(await assets.names()), ...models.map(({ name }) => name)])].sort();
}

/** Describes an asset set after a look at each of its files. [EX-57] */
export async function describeAssetSet(
  name: string,
  { assets, folder, mirror, model }: AssetSetPlaces,
): Promise<AssetSet> {
  const known: AssetSet = {
    name,
    description: model?.description ?? '',
    version: model?.version ?? '',
    licence: model?.licence ?? '',
    source: model?.source ?? '',
    bytes: model === undefined ? 0 : modelBytes(model),
    files: model?.files.length ?? 0,
    state: AssetSetState.ASSET_SET_STATE_MISSING,
    problem: '',
    bundled: false,
    address: model === undefined ? '' : modelAddress(model, mirror),
    publisherAddress: model?.address ?? '',
    folder: join(folder, name),
    download: undefined,
  };
  try {
    const { version, licence, source, files } = await assets.manifest(name);
    for (const file of files) await assets.verify(name, file);
    // Of files that a person put there, no more is known than what they are.
    const isPublished = model !== undefined && haveSameFiles(files, model.files);
    return {
      ...known,
      version: version || (isPublished ? known.version : ''),
      licence: licence || (isPublished ? known.licence : ''),
      source: source || (isPublished ? known.source : ''),
      bytes: modelBytes({ files }),
      files: files.length,
      state: AssetSetState.ASSET_SET_STATE_PRESENT,
      bundled: (await assets.parentOf(name)) !== folder,
    };
  } catch (error) {
    // Its folder is being replaced.
    if ((error as NodeJS.ErrnoException).code === 'ENOENT') return known;
    if (!(error instanceof AssetError)) throw error;
    if (error.code === 'missing') return known;
    // Paths are for admins.
    const problem = error.message.replaceAll(folder, 'models');
    return { ...known, state: AssetSetState.ASSET_SET_STATE_DAMAGED, problem };
  }
}

type Files = KnownModel['files'];

function haveSameFiles(one: Files, other: Files): boolean {
  const text = (files: Files): string =>
    JSON.stringify(files.map(({ path, sha256 }) => [path, sha256]).sort());
  return text(one) === text(other);
}
