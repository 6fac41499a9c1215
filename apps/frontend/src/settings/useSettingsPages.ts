import { computed, type ComputedRef } from 'vue';
import { useConnection } from '../connection/useConnection.ts';
import { SETTINGS_PAGES, type SettingsPage } from './settings-pages.ts';

/** Pages of the settings that this master has: one that is alone has none for a cluster. */
export function useSettingsPages(): ComputedRef<readonly SettingsPage[]> {
  const { master } = useConnection();
  const isInCluster = computed(() => master.view.value?.latest.cluster !== undefined);
  return computed(() =>
    isInCluster.value ? SETTINGS_PAGES : SETTINGS_PAGES.filter((page) => !page.isOfCluster),
  );
}
