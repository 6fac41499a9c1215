import { useLocalStorage } from '@vueuse/core';
import { computed, shallowRef, type ComputedRef } from 'vue';
import { thisPlatform } from '../connection/platform.ts';

/** https://wicg.github.io/manifest-incubations/#beforeinstallpromptevent-interface */
interface InstallPromptEvent extends Event {
  prompt(): Promise<{ readonly outcome: 'accepted' | 'dismissed' }>;
}

/** Install prompt of the browser, which fires once, before the page needs it. */
const offered = shallowRef<InstallPromptEvent>();

/** Stores the browser's install prompt until a page can show it. Call once, at startup. */
export function keepInstallOffer(): void {
  addEventListener('beforeinstallprompt', (event) => {
    event.preventDefault();
    offered.value = event as InstallPromptEvent;
  });
  addEventListener('appinstalled', () => (offered.value = undefined));
}

/** True when the page runs as an installed app. */
export function isInstalled(): boolean {
  const isOnHomeScreen = (navigator as { standalone?: boolean }).standalone === true; // iOS
  return isOnHomeScreen || matchMedia('(display-mode: standalone)').matches;
}

/** `button`: the browser asks the user; `words`: iOS, where only the user can install it; `none` */
export type InstallWay = 'button' | 'words' | 'none';

/** Installation of this page as an app. */
export function useInstallOffer(): {
  readonly way: ComputedRef<InstallWay>;
  install(): Promise<void>;
  /** Never asks again in this browser. */
  decline(): void;
} {
  const isDeclined = useLocalStorage('ubii.install.declined', false);
  const way = computed<InstallWay>(() => {
    if (isDeclined.value || isInstalled()) return 'none';
    if (offered.value) return 'button';
    return isSecureContext && thisPlatform() === 'ios' ? 'words' : 'none';
  });
  return {
    way,
    async install() {
      const offer = offered.value;
      // The prompt can be used once.
      offered.value = undefined;
      await offer?.prompt();
    },
    decline: () => void (isDeclined.value = true),
  };
}
