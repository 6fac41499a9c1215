import type { AssetFile, AssetManifest } from './asset-manifest.ts';

/** Source of asset sets. All rejections are `AssetError`s, or the reason of the signal. */
export interface AssetSource {
  manifest(name: string, signal: AbortSignal): Promise<AssetManifest>;
  /**
   * The bytes of one file, not verified.
   * @param onBytes called with the size of each received part, bytes
   */
  read(
    name: string,
    file: AssetFile,
    signal: AbortSignal,
    onBytes: (bytes: number) => void,
    /** Not out of a cache on the way, which may hold what was damaged before. */
    isFresh?: boolean,
  ): Promise<Uint8Array<ArrayBuffer>>;
}
