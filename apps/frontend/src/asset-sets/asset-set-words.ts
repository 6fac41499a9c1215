import { AssetSetState, type AssetSet, type AssetSetDownload } from '@ubii/proto';
import { formatNumber } from '../ui/readouts/format-number.ts';
import { formatUptime } from '../ui/readouts/format-time.ts';
import type { MarkedState } from '../ui/UiStateMark.vue';

const MEGABYTE = 1e6;

/** Formats a size: `18.6 MB`. */
export function megabytes(bytes: number): string {
  return `${formatNumber(bytes / MEGABYTE, 1)} MB`;
}

/** Formats the progress: `7.8 of 18.6 MB, 12 s left`; without a time until data has arrived. */
export function downloadWords(download: AssetSetDownload): string {
  const { loadedBytes, totalBytes, elapsedMs } = download;
  const loaded = `${formatNumber(loadedBytes / MEGABYTE, 1)} of ${megabytes(totalBytes)}`;
  if (loadedBytes === 0) return loaded;
  const leftMs = (elapsedMs / loadedBytes) * (totalBytes - loadedBytes);
  return `${loaded}, ${formatUptime(leftMs)} left`;
}

/** Availability of an asset set, as a mark and a word. */
export function assetSetLook({ state, bundled }: Pick<AssetSet, 'state' | 'bundled'>): {
  /** Undefined when the set is available. */
  readonly mark?: MarkedState;
  readonly word: string;
} {
  switch (state) {
    case AssetSetState.ASSET_SET_STATE_PRESENT:
      return { word: bundled ? 'Included' : 'Installed' };
    case AssetSetState.ASSET_SET_STATE_DAMAGED:
      return { mark: 'error', word: 'Damaged' };
    default:
      return { mark: 'stopped', word: 'Not installed' };
  }
}

/** Returns instructions for an admin to install a set that the master cannot download. */
export function wayOut({
  name,
  publisherAddress,
  folder,
}: Pick<AssetSet, 'name' | 'publisherAddress' | 'folder'>): string {
  return `On a computer with internet access, run "npm run models -- get ${name}" or download the files from ${publisherAddress}. Then put them into ${folder} on the computer of the master. Or start the master with --model-mirror <url>.`;
}
