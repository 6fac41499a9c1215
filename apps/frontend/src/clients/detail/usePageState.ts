import { computed, type ComputedRef } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { pageStateTopic, readPageState, type PageState } from '../../connection/page-state.ts';

/** What the page of a client says of itself; `undefined` while it says nothing. [EX-56] */
export function usePageState(clientId: () => string): ComputedRef<PageState | undefined> {
  const { newest } = useTopic(() => pageStateTopic(clientId()), { format: 'string' });
  return computed(() => newest.value && readPageState(newest.value.value));
}
