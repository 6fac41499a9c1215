import { useEventListener } from '@vueuse/core';
import { shallowRef, type Ref, type ShallowRef } from 'vue';
import { randomUuid } from '../../../connection/random-uuid.ts';
import { useFileDrop } from '../../../files/useFileDrop.ts';
import { sessionLocation } from '../../../locations/session-location.ts';
import type { SessionCalls } from '../../../sessions/actions/session-calls.ts';
import { drawnSize } from '../../nodes/drawn-size.ts';
import { addSession } from '../../model/add-session.ts';
import { missingWords } from '../../model/complete-session.ts';
import { CLIPBOARD_FORMAT } from '../../model/selection/clipboard.ts';
import type { GraphEditor } from '../../editing/graph-editor.ts';
import type { PreparedFile } from './prepared-file.ts';
import { useSessionImport, type SessionImport } from './useSessionImport.ts';

/** Import of files and pasted texts into a graph. */
export interface GraphImport {
  readonly files: SessionImport;
  /** True while files are dragged over the editor. */
  readonly isOver: Readonly<ShallowRef<boolean>>;
  /** Warnings after an import, one sentence. */
  readonly said: ShallowRef<string | undefined>;
  /** Adds the parsed content to this graph, as one undo step. */
  add(): void;
}

/** Vertical distance of imported nodes from existing ones, canvas units. */
const GAP = 64;
/** Shortest text treated as a session, characters; shorter ones are copied words. */
const MIN_TEXT = 20;

export function useGraphImport(
  page: Readonly<Ref<HTMLElement | null>>,
  editor: GraphEditor,
  calls: SessionCalls,
): GraphImport {
  const files = useSessionImport({
    calls,
    isAsking: () => true,
    locationOf: sessionLocation,
  });
  const said = shallowRef<string>();
  const isOver = useFileDrop(page, (dropped) => void files.take(dropped));

  function bottomLeft(): { x: number; y: number } {
    const { places, graph } = editor;
    const boxes = [...places.value].flatMap(([id, { x, y }]) => {
      const node = graph.value.nodes.get(id);
      return node === undefined ? [] : [{ x, bottom: y + drawnSize(node).height }];
    });
    if (boxes.length === 0) return { x: 40, y: 40 };
    return {
      x: Math.min(...boxes.map(({ x }) => x)),
      y: Math.max(...boxes.map(({ bottom }) => bottom)) + GAP,
    };
  }

  function addOne(file: Extract<PreparedFile, { kind: 'ready' }>): string | undefined {
    const isEmpty = editor.graph.value.nodes.size === 0;
    const added = addSession(editor.graph.value, file.session, {
      uuid: randomUuid,
      position: bottomLeft(),
      sizeOf: drawnSize,
      label: `Add ${file.session.name || file.name}`,
    });
    if (added.kind === 'broken') return `${file.name}: ${added.reason}`;
    editor.apply(added.command);
    if (!isEmpty) editor.select(added.ids);
    return missingWords(file.missing) || undefined;
  }

  useEventListener(window, 'paste', (event: ClipboardEvent) => {
    const target = event.target as HTMLElement | null;
    if (event.defaultPrevented || target?.closest('input, textarea, [contenteditable]')) return;
    const text = event.clipboardData?.getData('text/plain').trim() ?? '';
    const pasted = [...(event.clipboardData?.files ?? [])];
    if (pasted.length > 0) {
      event.preventDefault();
      void files.take(pasted);
    } else if (text.length > MIN_TEXT && /^[[{]/.test(text) && !text.includes(CLIPBOARD_FORMAT)) {
      event.preventDefault();
      void files.take([new File([text], 'The pasted text', { type: 'application/json' })]);
    }
  });

  return {
    files,
    isOver,
    said,
    add() {
      const ready = files.asked.value ?? [];
      files.cancel();
      const words = ready.map((file) => (file.kind === 'ready' ? addOne(file) : undefined));
      said.value = words.filter((one) => one !== undefined).join(' ') || undefined;
    },
  };
}
