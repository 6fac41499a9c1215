import type { AssetSet } from '@ubii/proto';
import type { AssetSets } from '../core/ports/asset-sets.ts';

/** Asset sets in memory, whose downloads never end. */
export class FakeAssetSets implements AssetSets {
  sets: readonly AssetSet[] = [];
  /** Names of the sets that are being downloaded. */
  readonly running = new Set<string>();

  list(): Promise<readonly AssetSet[]> {
    return Promise.resolve(this.sets);
  }

  download(name: string): Promise<void> {
    this.running.add(name);
    return Promise.resolve();
  }

  cancel(name: string): void {
    this.running.delete(name);
  }
}
