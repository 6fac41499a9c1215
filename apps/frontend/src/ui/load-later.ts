import { defineAsyncComponent, type Component } from 'vue';

/** Between two tries, milliseconds. */
const RETRY_MS = 2000;

/**
 * A part of a page whose program is loaded when it is shown first. While the master is away it is
 * tried again: the part appears when the master is back, and nothing else of the page fails with it.
 */
export function loadLater<T extends Component>(load: () => Promise<{ default: T }>): T {
  return defineAsyncComponent({
    loader: () => load().then((loaded) => loaded.default),
    onError: (_error, retry) => setTimeout(retry, RETRY_MS),
  });
}
