import { onScopeDispose, watch, type Ref } from 'vue';

/** Sends when something changes, once a frame at most, while `isOn`. */
export function useLiveSending(
  changing: Readonly<Ref<unknown>>,
  isOn: Readonly<Ref<boolean>>,
  send: () => void,
): void {
  let frame: number | undefined;
  watch(changing, () => {
    if (!isOn.value || frame !== undefined) return;
    frame = requestAnimationFrame(() => {
      frame = undefined;
      if (isOn.value) send();
    });
  });
  onScopeDispose(() => frame !== undefined && cancelAnimationFrame(frame));
}
