import { defineAsyncComponent, type Component } from 'vue';

/** Delay between attempts, milliseconds. */
const RETRY_MS = 2000;

/**
 * Loads a component on first use. Retries while the master is disconnected, so that the component appears after
 * reconnecting, and the rest of the page is unaffected.
 */
export function loadLater<T extends Component>(load: () => Promise<{ default: T }>): T {
  return defineAsyncComponent({
    loader: () => load().then((loaded) => loaded.default),
    onError: (_error, retry) => setTimeout(retry, RETRY_MS),
  });
}
