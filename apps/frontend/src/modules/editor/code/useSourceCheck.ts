import type { SandboxFactory } from '@ubii/pm-sandbox';
import { parseModule } from '@ubii/pm-sandbox';
import { watchDebounced } from '@vueuse/core';
import { computed, shallowRef, type ComputedRef } from 'vue';
import { moduleOf, type ModuleDraft } from '../draft/module-draft.ts';
import { placeInText, splitText } from '../text/module-text.ts';
import type { CodeMark } from './code-mark.ts';

const DELAY_MS = 250;

/** Problems of the text, and errors of the sandbox, which is the engine that runs untrusted modules on all nodes. */
export function useSourceCheck(
  draft: () => ModuleDraft | undefined,
  sandboxes: () => Promise<SandboxFactory>,
): ComputedRef<readonly CodeMark[]> {
  const text = computed(() => splitText(draft()?.code ?? ''));
  const fault = shallowRef<CodeMark>();

  watchDebounced(
    () => draft()?.code,
    async (code) => {
      const now = draft();
      const source = now && parseModule(moduleOf(now)).source;
      if (!source || splitText(now.code).problems.some(({ severity }) => severity === 'error')) {
        fault.value = undefined;
        return;
      }
      const found = await (await sandboxes()).check(source);
      // Ignore outdated results.
      if (draft()?.code !== code) return;
      const place = found && (placeInText(text.value, found) ?? { line: 1, column: 1 });
      fault.value = found && place && { ...place, severity: 'error', message: found.message };
    },
    { debounce: DELAY_MS, immediate: true },
  );
  return computed(() => [...text.value.problems, ...(fault.value ? [fault.value] : [])]);
}
