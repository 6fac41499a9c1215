import { useEventListener } from '@vueuse/core';
import { shallowRef, type Ref, type ShallowRef } from 'vue';
import { randomUuid } from '../../connection/random-uuid.ts';
import type { GraphEditor } from '../editor/graph-editor.ts';
import { copyText, paste } from '../model/selection/clipboard.ts';

/**
 * Copies, cuts and pastes nodes as text, within a graph and across sessions, while the canvas has the
 * focus. @returns why the last text could not be pasted
 */
export function useGraphClipboard(
  host: Ref<HTMLElement | null>,
  editor: GraphEditor,
): Readonly<ShallowRef<string | undefined>> {
  const problem = shallowRef<string>();
  const isHere = (): boolean => {
    const active = document.activeElement;
    if (active === null || /^(INPUT|TEXTAREA)$/.test(active.tagName)) return false;
    return host.value?.contains(active) === true;
  };
  function copy(event: ClipboardEvent): boolean {
    const { nodes } = editor.selection.value;
    if (!isHere() || nodes.size === 0) return false;
    event.clipboardData?.setData('text/plain', copyText(editor.graph.value, [...nodes]));
    event.preventDefault();
    return true;
  }
  useEventListener(document, 'copy', copy);
  useEventListener(document, 'cut', (event: ClipboardEvent) => {
    const { nodes } = editor.selection.value;
    if (copy(event)) editor.apply({ kind: 'remove', nodes: [...nodes] });
  });
  useEventListener(document, 'paste', (event: ClipboardEvent) => {
    problem.value = undefined;
    if (!isHere()) return;
    const text = event.clipboardData?.getData('text/plain') ?? '';
    const pasted = paste(editor.graph.value, text, { uuid: randomUuid });
    if (pasted.kind === 'foreign') return;
    event.preventDefault();
    if (pasted.kind === 'broken') {
      problem.value = pasted.reason;
      return;
    }
    editor.apply(pasted.command);
    editor.select(pasted.ids);
  });
  return problem;
}
