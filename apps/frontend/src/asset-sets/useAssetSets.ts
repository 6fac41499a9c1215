import { ConnectionError } from '@ubii/client-web';
import { AssetSetState, ServiceError, type AssetSet } from '@ubii/proto';
import { computed, shallowRef, toValue, type MaybeRefOrGetter } from 'vue';
import { usePoll } from '../connection/poll.ts';
import { useConnection } from '../connection/useConnection.ts';

/** Interval of requests, milliseconds: manual changes of files are not announced. */
const IDLE_MS = 3000;
const DOWNLOADING_MS = 400;

/**
 * Asset sets of the master, updated while the calling component is mounted. [EX-57]
 *
 * @param enabled false while they are not shown
 */
export function useAssetSets(enabled: MaybeRefOrGetter<boolean> = true) {
  const { client, isConnected } = useConnection();
  /** `undefined` until the first reply, and where the master or the role does not provide them. */
  const sets = shallowRef<readonly AssetSet[]>();
  /** Reason why the last request was refused, by the name of the set. */
  const refusals = shallowRef<ReadonlyMap<string, string>>(new Map());
  const isDownloading = computed(() => sets.value?.some(({ download }) => download?.running));

  async function refresh(): Promise<void> {
    try {
      sets.value = (await client.call('assetSetList')).elements;
    } catch (cause) {
      if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
    }
  }
  usePoll(
    refresh,
    () => (isDownloading.value ? DOWNLOADING_MS : IDLE_MS),
    () => isConnected.value && toValue(enabled),
  );

  async function ask(service: 'assetSetDownload' | 'assetSetCancel', name: string): Promise<void> {
    let refusal: string | undefined;
    try {
      await client.call(service, { name });
    } catch (cause) {
      if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
      refusal = cause.message;
    }
    refusals.value = new Map(refusals.value).set(name, refusal ?? '');
    await refresh();
  }

  return {
    sets,
    refusals,
    find: (name: string) => sets.value?.find((set) => set.name === name),
    download: (name: string) => ask('assetSetDownload', name),
    cancel: (name: string) => ask('assetSetCancel', name),
  };
}

export type AssetSets = ReturnType<typeof useAssetSets>;

/** Whether modules can load a set. */
export function isPresent(set: AssetSet | undefined): boolean {
  return set?.state === AssetSetState.ASSET_SET_STATE_PRESENT;
}
