import { onScopeDispose, toValue, watchEffect, type MaybeRefOrGetter } from 'vue';

/** The bars of the browser around the page have its colour, too. */
export function usePageColour(colour: MaybeRefOrGetter<string>): void {
  const meta = document.createElement('meta');
  meta.name = 'theme-color';
  document.head.append(meta);
  watchEffect(() => {
    meta.content = toValue(colour);
    document.documentElement.style.background = toValue(colour);
  });
  onScopeDispose(() => {
    meta.remove();
    document.documentElement.style.removeProperty('background');
  });
}
