/** Files that modules are handed, under one name. */
export interface AssetSet {
  readonly name: string;
  /** Version of the package that carries the files. */
  readonly version: string;
  /** SPDX expression. */
  readonly licence: string;
  readonly source: string;
  readonly folder?: () => string;
  readonly files: readonly string[];
  /** The file that is a script, whose value is a library. */
  readonly library?: string;
  /** Makes the files of what is installed. */
  readonly make?: () => Record<string, Uint8Array>;
  /** The licence that has to go with copies. */
  readonly licenceFile?: () => string;
}

export const ASSET_SETS: readonly AssetSet[];

/** Reads the files of an asset set out of the installed packages. */
export function readAssetSet(name: string): Record<string, Uint8Array>;

/** Writes all asset sets, each as a folder with its files, `manifest.json` and, where it has to be, `LICENSE`. */
export function writeAssetSets(outdir: string, library?: string): void;
