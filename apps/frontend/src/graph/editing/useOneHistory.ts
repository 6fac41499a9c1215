import { useEventListener } from '@vueuse/core';
import type { Ref } from 'vue';
import type { GraphEditor } from './graph-editor.ts';

/** Fields whose changes are steps of the graph have this attribute, on them or around them. */
const ONE_HISTORY = '[data-one-history]';
const FIELD = ['input', 'textarea', 'select', '[contenteditable]'].join();

/**
 * Undo and redo keys inside an editor, also in fields of values: the browser's own undo would bring back texts that
 * were refused. Other text fields, such as notes, keep the browser's undo.
 */
export function useOneHistory(
  root: Readonly<Ref<HTMLElement | null>>,
  editor: Pick<GraphEditor, 'undo' | 'redo'>,
): void {
  useEventListener(window, 'keydown', (event: KeyboardEvent) => {
    const { target, defaultPrevented, altKey } = event;
    if (defaultPrevented || altKey || !(event.ctrlKey || event.metaKey)) return;
    const key = event.key.toLowerCase();
    if ((key !== 'z' && key !== 'y') || !(target instanceof Element)) return;
    if (target !== document.body && root.value?.contains(target) !== true) return;
    if (target.matches(FIELD) && target.closest(ONE_HISTORY) === null) return;
    event.preventDefault();
    if (key === 'y' || event.shiftKey) editor.redo();
    else editor.undo();
  });
}
