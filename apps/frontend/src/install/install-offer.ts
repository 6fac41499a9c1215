import { useLocalStorage } from '@vueuse/core';
import { computed, shallowRef, type ComputedRef } from 'vue';
import { thisPlatform } from '../connection/platform.ts';

/** https://wicg.github.io/manifest-incubations/#beforeinstallpromptevent-interface */
interface InstallPromptEvent extends Event {
  prompt(): Promise<{ readonly outcome: 'accepted' | 'dismissed' }>;
}

/** The install prompt of the browser, which it offers once, before the page needs it. */
const offered = shallowRef<InstallPromptEvent>();

/** Keeps the browser's offer until a page has a place for it. Call once, at the start. */
export function keepInstallOffer(): void {
  addEventListener('beforeinstallprompt', (event) => {
    event.preventDefault();
    offered.value = event as InstallPromptEvent;
  });
  addEventListener('appinstalled', () => (offered.value = undefined));
}

/** Opened from the home screen, with no browser around it. */
export function isInstalled(): boolean {
  const isOnHomeScreen = (navigator as { standalone?: boolean }).standalone === true; // iOS
  return isOnHomeScreen || matchMedia('(display-mode: standalone)').matches;
}

/** `button`: the browser asks the person · `words`: iOS, where only the person can do it · `none` */
export type InstallWay = 'button' | 'words' | 'none';

/** How this page can be made an app of this device. */
export function useInstallOffer(): {
  readonly way: ComputedRef<InstallWay>;
  install(): Promise<void>;
  /** Not to be asked again in this browser. */
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
      // It can be taken once
      offered.value = undefined;
      await offer?.prompt();
    },
    decline: () => void (isDeclined.value = true),
  };
}
