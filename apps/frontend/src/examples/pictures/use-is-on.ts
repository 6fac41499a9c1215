import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';
import { useRoute } from 'vue-router';
import { useToasts } from '../../ui/toasts/toasts.ts';

/** Whether an example runs. It ends with the page; after a reload the page offers to start it again. */
export function useIsOn(): ShallowRef<boolean> {
  const isOn = shallowRef(false);
  const toasts = useToasts();
  const key = `ubii.example-ran.${useRoute().path}`;
  if (sessionStorage.getItem(key) !== null) {
    const run = (): void => void (isOn.value = true);
    toasts.show('The example ran until the page was reloaded.', { text: 'Start again', run }, key);
    sessionStorage.removeItem(key);
  }
  useEventListener(window, 'pagehide', ({ persisted }) => {
    // One that is kept goes on when it is shown again
    if (isOn.value && !persisted) sessionStorage.setItem(key, 'yes');
  });
  onScopeDispose(() => toasts.leave(key));
  return isOn;
}
