import type { AssetSet } from '@ubii/proto';

/** The asset sets of this master, and downloads of those it knows. */
export interface AssetSets {
  /** By name; with the folder of each, which is for admins. [EX-57] */
  list(): Promise<readonly AssetSet[]>;
  /**
   * Starts a download. Does nothing when it is under way. [EX-58]
   *
   * @throws ServiceError when the set is unknown, or is there already
   */
  download(name: string): Promise<void>;
  /** Ends a download, of which nothing is left. Does nothing when there is none. */
  cancel(name: string): void;
}
