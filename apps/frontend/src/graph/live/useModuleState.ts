import type { ProcessingModule } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { OUT_OF_CONTACT, sessionState } from '../../sessions/state/session-state.ts';
import { moduleStatus, type StatusLook } from '../../sessions/words/module-status.ts';
import { useGraphContext } from './useGraphContext.ts';
import { useGraphProblems } from './useGraphProblems.ts';
import { INPUT_REQUIRED } from '../model/live/module-faults.ts';
import type { ModuleNode } from '../model/graph.ts';
import { isSameTrouble, moduleTrouble, type ModuleTrouble } from './module-trouble.ts';

/** State of a module on the master. */
export interface ModuleState {
  /** Undefined while the module is not saved. */
  readonly real: ComputedRef<ProcessingModule | undefined>;
  readonly trouble: ComputedRef<ModuleTrouble>;
  readonly status: ComputedRef<StatusLook | undefined>;
}

export function useModuleState(node: () => ModuleNode): ModuleState {
  const { editor, live } = useGraphContext();
  const { isConnected, topics } = useConnection();
  const real = computed(() =>
    editor.session.value.processingModules.find(({ id }) => id === node().module.id),
  );
  const trouble = computed<ModuleTrouble>((before) => {
    const { id } = node().module;
    const nowMs = topics.masterTimeMs.value;
    const now = moduleTrouble(editor.session.value, live.events.value, id, nowMs);
    // The clock ticks: keep the previous object unless the result differs, to spare hundreds of views.
    return before !== undefined && isSameTrouble(before, now) ? before : now;
  });
  const problems = useGraphProblems();
  const waiting = computed(() =>
    problems.ofNode(node().id).find(({ code }) => code === INPUT_REQUIRED),
  );
  const status = computed((): StatusLook | undefined => {
    if (real.value !== undefined && !isConnected.value) return OUT_OF_CONTACT;
    if (waiting.value?.consequence !== undefined) {
      return { mark: 'warning', word: waiting.value.consequence };
    }
    const isFailing = trouble.value.failure !== undefined;
    return real.value && moduleStatus(real.value, sessionState(editor.session.value), isFailing);
  });
  return { real, trouble, status };
}
