import { computed, type ComputedRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { OUT_OF_CONTACT } from '../../sessions/state/session-state.ts';
import type { MarkedState } from '../../ui/UiStateMark.vue';

/** Status mark and its text. */
export interface ExampleState {
  readonly state: MarkedState;
  readonly word: string;
}

/** Status of an example with pictures. */
export function useExampleStatus(example: {
  readonly isOn: () => boolean;
  /** True when a reload ended it. */
  readonly wasEnded: () => boolean;
  readonly isStarting: () => boolean;
  /** True when there is a problem. */
  readonly hasProblem: () => boolean;
  /** Name of what is loaded before the module starts; `undefined` when nothing is. */
  readonly loads: () => string | undefined;
  /** True when results arrived recently. */
  readonly hasResults: () => boolean;
}): ComputedRef<ExampleState> {
  const { isConnected } = useConnection();
  return computed(() => {
    if (!example.isOn()) {
      return {
        state: 'stopped',
        word: example.wasEnded() ? 'Stopped by the reload' : 'Not started',
      };
    }
    if (!isConnected.value) return { state: 'away', word: OUT_OF_CONTACT.word };
    if (example.hasProblem()) return { state: 'error', word: 'Error' };
    const loads = example.loads();
    if (loads !== undefined) return { state: 'away', word: `Loading ${loads}` };
    if (example.isStarting()) return { state: 'away', word: 'Starting' };
    return example.hasResults()
      ? { state: 'live', word: 'Live' }
      : { state: 'away', word: 'Waiting for a result' };
  });
}
