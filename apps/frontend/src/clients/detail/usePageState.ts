import { shallowRef, watch, type ShallowRef } from 'vue';
import { pageStateTopic, readPageState, type PageState } from '../../connection/page-state.ts';
import { useConnection } from '../../connection/useConnection.ts';

/** What the page of a client says of itself; `undefined` while it says nothing. [EX-56] */
export function usePageState(clientId: () => string): Readonly<ShallowRef<PageState | undefined>> {
  const { client } = useConnection();
  const state = shallowRef<PageState>();
  watch(
    clientId,
    (id, _before, onCleanup) => {
      state.value = undefined;
      const subscription = client
        .subscribe(pageStateTopic(id), { format: 'string' })
        .onRecord(({ value }) => (state.value = readPageState(value)));
      onCleanup(() => void subscription.close());
    },
    { immediate: true },
  );
  return state;
}
