import type { SandboxFactory } from '@ubii/pm-sandbox';
import { parseModule } from '@ubii/pm-sandbox';
import { watchDebounced } from '@vueuse/core';
import { computed, shallowRef, type ComputedRef } from 'vue';
import type { EditedModule } from '../../draft/edited-module.ts';
import { moduleOf } from '../../draft/module-draft.ts';
import { placeInText } from '../../text/module-text.ts';
import type { CodeMark } from './code-mark.ts';

const DELAY_MS = 250;

/** Problems of the text, and errors of the sandbox, which is the engine that runs untrusted modules on all nodes. */
export function useSourceCheck(
  { draft, code, text }: EditedModule,
  sandboxes: () => Promise<SandboxFactory>,
): ComputedRef<readonly CodeMark[]> {
  const fault = shallowRef<CodeMark>();

  watchDebounced(
    code,
    async (now) => {
      const isBroken = text.value.problems.some(({ severity }) => severity === 'error');
      const source =
        now === '' || isBroken ? undefined : parseModule(moduleOf(draft.value, text.value)).source;
      if (source === undefined) {
        fault.value = undefined;
        return;
      }
      const found = await (await sandboxes()).check(source);
      // Ignore outdated results.
      if (code.value !== now) return;
      const place = found && (placeInText(text.value, found) ?? { line: 1, column: 1 });
      fault.value = found && place && { ...place, severity: 'error', message: found.message };
    },
    { debounce: DELAY_MS, immediate: true },
  );
  return computed(() => [...text.value.problems, ...(fault.value ? [fault.value] : [])]);
}
