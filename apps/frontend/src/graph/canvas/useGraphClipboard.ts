import { useEventListener } from '@vueuse/core';
import { shallowRef, type Ref, type ShallowRef } from 'vue';
import { randomUuid } from '../../connection/random-uuid.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';
import type { Point } from '../model/graph.ts';
import { copyText, paste } from '../model/selection/clipboard.ts';

/** Nodes copied and pasted as text, within a graph and across sessions. */
export interface GraphClipboard {
  /** Reason why the last text could not be pasted. */
  readonly problem: Readonly<ShallowRef<string | undefined>>;
  copy(nodes: readonly string[]): void;
  cut(nodes: readonly string[]): void;
  /** Pastes the clipboard with its top left at a position. */
  pasteAt(at: Point): Promise<void>;
}

/** Text that was copied last in this tab: pages without a secure context cannot read the clipboard. */
let lastCopied = '';

/** Keys copy, cut and paste while the canvas has the focus. */
export function useGraphClipboard(
  host: Ref<HTMLElement | null>,
  editor: GraphEditor,
): GraphClipboard {
  const problem = shallowRef<string>();
  const isHere = (): boolean => {
    const active = document.activeElement;
    if (active === null || /^(INPUT|TEXTAREA)$/.test(active.tagName)) return false;
    return host.value?.contains(active) === true;
  };
  function take(event: ClipboardEvent): boolean {
    const { nodes } = editor.selection.value;
    if (!isHere() || nodes.size === 0) return false;
    lastCopied = copyText(editor.graph.value, [...nodes]);
    event.clipboardData?.setData('text/plain', lastCopied);
    event.preventDefault();
    return true;
  }
  /** @returns true when the text was a graph */
  function put(text: string, position?: Point): boolean {
    problem.value = undefined;
    const pasted = paste(editor.graph.value, text, { uuid: randomUuid, position });
    if (pasted.kind === 'foreign') return false;
    if (pasted.kind === 'broken') {
      problem.value = pasted.reason;
      return true;
    }
    editor.apply(pasted.command);
    editor.select(pasted.ids);
    return true;
  }
  useEventListener(document, 'copy', take);
  useEventListener(document, 'cut', (event: ClipboardEvent) => {
    const { nodes } = editor.selection.value;
    if (take(event)) editor.apply({ kind: 'remove', nodes: [...nodes] });
  });
  useEventListener(document, 'paste', (event: ClipboardEvent) => {
    problem.value = undefined;
    if (isHere() && put(event.clipboardData?.getData('text/plain') ?? '')) event.preventDefault();
  });

  /** Dispatches the key's command, which works without a secure context, too. */
  function press(what: 'copy' | 'cut', nodes: readonly string[]): void {
    editor.select(nodes);
    if (!isHere()) host.value?.focus({ preventScroll: true });
    document.execCommand(what);
  }
  return {
    problem,
    copy: (nodes) => press('copy', nodes),
    cut: (nodes) => press('cut', nodes),
    async pasteAt(at) {
      const text = (await readClipboard()) ?? lastCopied;
      if (put(text, at) || put(lastCopied, at)) return;
      problem.value = 'There are no nodes to paste. Copy some first, here or in another session.';
    },
  };
}

async function readClipboard(): Promise<string | undefined> {
  try {
    return await navigator.clipboard.readText();
  } catch {
    // Permission denied, or no secure context.
    return undefined;
  }
}
