import { useSessionStorage } from '@vueuse/core';
import { computed, provide, watch, type InjectionKey } from 'vue';
import { injectOrThrow } from '../../../context/inject-or-throw.ts';
import { useRoute } from 'vue-router';
import { useConnection } from '../../../connection/useConnection.ts';
import { useOwnPointer } from '../../../graph/editor/templates/own-pointer.ts';
import { isAlive } from '../../../sessions/state/session-state.ts';
import type { InputName } from './input-names.ts';
import { usePageDevice } from './usePageDevice.ts';

/** Inputs of this page for the sessions that were started in it. */
export interface PageInputs {
  /** Publishes these inputs while the session runs, which was started in this page. */
  give(sessionId: string, inputs: readonly InputName[]): void;
}

const PAGE_INPUTS: InjectionKey<PageInputs> = Symbol('page inputs');
/** The page that publishes the pointer device itself. */
const POINTER_PAGE = '/examples/mouse-pointer';

/**
 * Publishes pointer, clicks and keys of this browser tab while a session runs that was started in it, on
 * every route and after a reload. Sessions started by other clients do not enable it.
 */
export function providePageInputs(): void {
  const { sessions } = useConnection();
  const route = useRoute();
  const given = useSessionStorage<Readonly<Record<string, readonly InputName[]>>>(
    'ubii.examples.inputs',
    {},
  );
  const needed = computed(
    () =>
      new Set(
        (sessions.list.value ?? [])
          .filter(isAlive)
          .flatMap(({ id }) => (Object.hasOwn(given.value, id) ? (given.value[id] ?? []) : [])),
      ),
  );

  const own = useOwnPointer();
  const needsPointer = computed(() => needed.value.has('pointer') && route.path !== POINTER_PAGE);
  watch(needsPointer, (needs) => (own.isOn.value = needs));
  usePageDevice(
    computed(() =>
      ['pressed', 'escape', 'key'].some((name) => needed.value.has(name as InputName)),
    ),
    computed(() => needed.value.has('key')),
  );

  provide(PAGE_INPUTS, {
    give: (id, inputs) => (given.value = { ...given.value, [id]: [...inputs] }),
  });
}

export function usePageInputs(): PageInputs {
  return injectOrThrow(PAGE_INPUTS, 'the page inputs of the shell');
}
