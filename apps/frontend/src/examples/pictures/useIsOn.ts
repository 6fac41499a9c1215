import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef, watch, type ShallowRef } from 'vue';
import { useRoute } from 'vue-router';
import type { PictureSources } from './usePictureSource.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';

/** Whether an example runs. It ends with the page; after a reload, the page offers to start it again. */
export function useIsOn(sources: Pick<PictureSources, 'kind'>): {
  readonly isOn: ShallowRef<boolean>;
  /** True when a reload ended it, and it was not started again. */
  readonly wasEnded: Readonly<ShallowRef<boolean>>;
} {
  const isOn = shallowRef(false);
  const wasEnded = shallowRef(false);
  const toasts = useToasts();
  const key = `ubii.example-ran.${useRoute().path}`;
  if (sessionStorage.getItem(key) !== null) {
    const run = (): void => void (isOn.value = true);
    toasts.show('The reload of this page stopped the example.', { text: 'Start again', run }, key);
    sessionStorage.removeItem(key);
    wasEnded.value = true;
  }
  watch(isOn, () => (wasEnded.value = false));
  useEventListener(window, 'pagehide', ({ persisted }) => {
    // Sources that are kept resume when the page is shown again.
    const isKept = ['clip', 'camera'].includes(sources.kind.value);
    if (isOn.value && isKept && !persisted) sessionStorage.setItem(key, 'yes');
  });
  onScopeDispose(() => toasts.leave(key));
  return { isOn, wasEnded };
}
