import { callWorker, type WorkerPeer } from '@ubii/worker-rpc/browser';
import { useIntersectionObserver } from '@vueuse/core';
import {
  computed,
  onBeforeUnmount,
  provide,
  shallowRef,
  watch,
  type ComputedRef,
  type InjectionKey,
  type ShallowRef,
} from 'vue';
import { injectOrThrow } from '../../context/inject-or-throw.ts';
import type { PreviewRequest, PreviewWorker } from './preview-messages.ts';
import { PreviewStore, type PreviewState } from './preview-store.ts';

const PREVIEWS: InjectionKey<PreviewStore> = Symbol('previews');

const openPreviewWorker = (): WorkerPeer<PreviewWorker> =>
  callWorker(
    new Worker(new URL('./preview-worker.ts', import.meta.url), { type: 'module' }),
    {},
    'This browser cannot read recordings.',
  );

/** Keeps previews as long as the page is open. */
export function providePreviews(open = openPreviewWorker): PreviewStore {
  const store = new PreviewStore(open);
  provide(PREVIEWS, store);
  onBeforeUnmount(() => store.close());
  return store;
}

export function usePreviews(): PreviewStore {
  return injectOrThrow(PREVIEWS, 'the page of recordings above it');
}

/** The preview of a recording, which is read while its element is on screen. @param request undefined for none */
export function usePreview(
  element: Readonly<ShallowRef<HTMLElement | null>>,
  request: () => PreviewRequest | undefined,
): ComputedRef<PreviewState | undefined> {
  const store = usePreviews();
  const isShown = shallowRef(false);
  useIntersectionObserver(element, (entries) => {
    isShown.value = entries.at(-1)?.isIntersecting === true;
  });
  watch(
    [isShown, () => request()?.key],
    ([shown], _before, onCleanup) => {
      const wanted = request();
      if (!shown || wanted === undefined) return;
      store.show(wanted);
      onCleanup(() => store.hide(wanted.key));
    },
    { immediate: true },
  );
  return computed(() => {
    const wanted = request();
    return wanted && store.get(wanted.key);
  });
}
