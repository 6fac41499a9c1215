import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef } from 'vue';

/**
 * `off`: the operating system released the lock, such as on a low battery; it is requested again when the page is
 * shown.
 */
export type StayAwakeState = 'insecure' | 'unsupported' | 'off' | 'on';

/**
 * Keeps the screen on while the calling scope is active. Browsers release the lock whenever the page is hidden, so it
 * is requested again on return.
 */
export function useStayAwake() {
  const state = shallowRef<StayAwakeState>(firstState());
  let lock: WakeLockSentinel | undefined;
  let isWanted = state.value === 'off';

  async function take(): Promise<void> {
    if (!isWanted || lock !== undefined || document.visibilityState !== 'visible') return;
    try {
      const taken = await navigator.wakeLock.request('screen');
      if (!isWanted || lock !== undefined) return void taken.release();
      lock = taken;
      state.value = 'on';
      taken.addEventListener('release', () => {
        if (lock === taken) lock = undefined;
        state.value = 'off';
      });
    } catch {
      state.value = 'off';
    }
  }

  void take();
  useEventListener(document, 'visibilitychange', () => void take());
  // Some browsers require a user interaction.
  useEventListener(window, 'pointerup', () => void take());
  onScopeDispose(() => {
    isWanted = false;
    void lock?.release();
  });
  return { state };
}

function firstState(): StayAwakeState {
  if (!isSecureContext) return 'insecure';
  return 'wakeLock' in navigator ? 'off' : 'unsupported';
}
