import type { AssetFolders } from '@ubii/pm-sandbox/node';
import { AssetSetState, ServiceError, type AssetSet } from '@ubii/proto';
import type { AssetSets } from '../../core/ports/asset-sets.ts';
import type { Log } from '../../core/ports/log.ts';
import { modelAddress, modelBytes, type KnownModel } from './catalogue.ts';
import { assetSetNames, describeAssetSet } from './describe-asset-set.ts';
import { DownloadError } from './download-model.ts';
import { downloadModel, removeLeftovers } from './download-model.ts';

/** Dependencies of a store of asset sets. */
export interface StoredAssetSetsContext {
  readonly assets: AssetFolders;
  /** `models/` of the data directory. */
  readonly folder: string;
  /** Models that can be downloaded. */
  readonly models: readonly KnownModel[];
  readonly mirror: string | undefined;
  readonly log: Log;
  readonly clock: { monotonicMs(): number };
}

/** A download under way, or one that failed. */
interface Download {
  readonly abort: AbortController;
  readonly startedMs: number;
  loadedBytes: number;
  done: Promise<void>;
  /** Empty while it is under way. */
  error: string;
}

/** Asset sets on disk, and downloads into the data directory: one at a time for each set. [EX-57] [EX-58] */
export class StoredAssetSets implements AssetSets {
  readonly #context: StoredAssetSetsContext;
  readonly #downloads = new Map<string, Download>();

  constructor(context: StoredAssetSetsContext) {
    this.#context = context;
    // Not awaited: leftovers are never read.
    for (const { name } of context.models)
      void removeLeftovers(context.folder, name).catch(() => {});
  }

  async list(): Promise<readonly AssetSet[]> {
    const { assets, models } = this.#context;
    const names = await assetSetNames(assets, models);
    return Promise.all(names.map((name) => this.#describe(name)));
  }

  async download(name: string): Promise<void> {
    const model = this.#context.models.find((one) => one.name === name);
    if (model === undefined) {
      throw new ServiceError(
        'not_found',
        `The master cannot download a model named "${name}". Put its files into the folder models/${name} of the data directory.`,
      );
    }
    if (this.#isRunning(name)) return;
    const { state } = await this.#describe(name);
    if (state === AssetSetState.ASSET_SET_STATE_PRESENT) {
      throw new ServiceError('already_exists', `The asset set ${name} is already installed.`);
    }
    if (!this.#isRunning(name)) this.#start(model);
  }

  cancel(name: string): void {
    this.#downloads.get(name)?.abort.abort();
  }

  /** Ends all downloads. */
  async close(): Promise<void> {
    const downloads = [...this.#downloads.values()];
    for (const { abort } of downloads) abort.abort();
    await Promise.all(downloads.map(({ done }) => done));
  }

  #start(model: KnownModel): void {
    const { folder, mirror, log, clock } = this.#context;
    const { name } = model;
    const abort = new AbortController();
    const { signal } = abort;
    const download: Download = {
      abort,
      startedMs: clock.monotonicMs(),
      loadedBytes: 0,
      error: '',
      done: Promise.resolve(),
    };
    this.#downloads.set(name, download);
    const from = modelAddress(model, mirror);
    log.info('a model is downloaded', { name, from, bytes: modelBytes(model) });
    const onProgress = (bytes: number): void => void (download.loadedBytes = bytes);
    download.done = downloadModel(model, { folder, mirror, signal, onProgress }).then(
      () => {
        this.#downloads.delete(name);
        log.info('the model is installed', { name });
      },
      (error: unknown) => {
        if (signal.aborted) {
          this.#downloads.delete(name);
          log.info('the download of the model was cancelled', { name });
          return;
        }
        download.error =
          error instanceof DownloadError ? error.message : 'The download failed. See the log.';
        log.warn('the model could not be downloaded', { name, reason: String(error) });
      },
    );
  }

  #isRunning(name: string): boolean {
    return this.#downloads.get(name)?.error === '';
  }

  async #describe(name: string): Promise<AssetSet> {
    const { assets, folder, mirror, models } = this.#context;
    const model = models.find((one) => one.name === name);
    // First: a download that ends while the files are looked at would leave a set that is missing and not under way.
    const download = this.#progress(name, model);
    const set = await describeAssetSet(name, { assets, folder, mirror, model });
    return { ...set, download };
  }

  #progress(name: string, model: KnownModel | undefined): AssetSet['download'] {
    const download = this.#downloads.get(name);
    if (download === undefined || model === undefined) return undefined;
    const { loadedBytes, startedMs, error } = download;
    return {
      running: error === '',
      loadedBytes,
      totalBytes: modelBytes(model),
      elapsedMs: this.#context.clock.monotonicMs() - startedMs,
      error,
    };
  }
}
