import { AssetSetState, type AssetSet } from '@ubii/proto';
import { computed, shallowRef, toValue, type MaybeRefOrGetter } from 'vue';
import { usePoll } from '../connection/poll.ts';
import { tryRequest, useAttemptByKey } from '../connection/useAttempt.ts';
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
  const { problems: refusals, attempt } = useAttemptByKey();
  const isDownloading = computed(() => sets.value?.some(({ download }) => download?.running));

  async function refresh(): Promise<void> {
    const reply = await tryRequest(() => client.call('assetSetList'));
    if (reply) sets.value = reply.elements;
  }
  usePoll(
    refresh,
    () => (isDownloading.value ? DOWNLOADING_MS : IDLE_MS),
    () => isConnected.value && toValue(enabled),
  );

  async function ask(service: 'assetSetDownload' | 'assetSetCancel', name: string): Promise<void> {
    await attempt(name, () => client.call(service, { name }));
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
