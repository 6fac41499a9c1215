import { computed, type ComputedRef } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { pageStateTopic, readPageState, type PageState } from '../../connection/page-state.ts';

/** State that the page of a client publishes; `undefined` without one. [EX-56] */
export function usePageState(clientId: () => string): ComputedRef<PageState | undefined> {
  const { newest } = useTopic(() => pageStateTopic(clientId()), { format: 'string' });
  return computed(() => newest.value && readPageState(newest.value.value));
}
