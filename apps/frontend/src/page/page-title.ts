import { onScopeDispose, toValue, watch, type MaybeRefOrGetter, type ShallowRef } from 'vue';
import { useShell } from './shell.ts';

/** Sets the title of the page, while the calling component is mounted; without a name, the route's title is used. */
export function usePageTitle(title: MaybeRefOrGetter<string | undefined>): void {
  tell(useShell().pageTitle, title);
}

/** Tells the shell which name the page has as its heading, so that the path in the top bar does not repeat it. */
export function usePageHeading(heading: MaybeRefOrGetter<string | undefined>): void {
  tell(useShell().pageHeading, heading);
}

function tell(
  told: ShallowRef<string | undefined>,
  text: MaybeRefOrGetter<string | undefined>,
): void {
  watch(
    () => toValue(text),
    (next) => (told.value = next),
    { immediate: true },
  );
  onScopeDispose(() => (told.value = undefined));
}
