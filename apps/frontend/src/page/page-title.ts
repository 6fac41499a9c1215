import { onScopeDispose, toValue, watch, type MaybeRefOrGetter } from 'vue';
import { useShell } from './shell.ts';

/** Sets the title of the page, while the calling component is mounted; without a name, the route's title is used. */
export function usePageTitle(title: MaybeRefOrGetter<string | undefined>): void {
  const { pageTitle } = useShell();
  watch(
    () => toValue(title),
    (next) => (pageTitle.value = next),
    { immediate: true },
  );
  onScopeDispose(() => (pageTitle.value = undefined));
}
