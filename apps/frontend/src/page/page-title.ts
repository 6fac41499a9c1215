import { onScopeDispose, toValue, watch, type MaybeRefOrGetter } from 'vue';
import { useShell } from './shell.ts';

/**
 * Names the page after the thing it shows, while the calling component lives; without a name, the
 * route's title stands.
 */
export function usePageTitle(title: MaybeRefOrGetter<string | undefined>): void {
  const { pageTitle } = useShell();
  watch(
    () => toValue(title),
    (next) => (pageTitle.value = next),
    { immediate: true },
  );
  onScopeDispose(() => (pageTitle.value = undefined));
}
