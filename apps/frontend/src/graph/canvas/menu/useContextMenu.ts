import { useEventListener } from '@vueuse/core';
import { nextTick, shallowRef, type Ref, type ShallowRef } from 'vue';
import { randomUuid } from '../../../connection/random-uuid.ts';
import type { GraphEditor } from '../../editing/graph-editor.ts';
import type { CanvasStage } from '../canvas-stage.ts';
import { spotsOnStage } from '../drag/insert-target.ts';
import { hoverTarget, type HoverTarget } from '../hover/hover-target.ts';
import { nearestOn } from '../wire-hit.ts';
import { drawnSize } from '../../nodes/drawn-size.ts';
import type { MenuAction, MenuEntry, MenuRequest, MenuTarget } from './menu-entry.ts';
import { menuOf, nodesMeant } from './menu-of.ts';
import { foundAt, type Found } from './target-of.ts';

/** An open menu, and its position on the page, pixels. */
export interface OpenMenu {
  readonly entries: readonly MenuEntry[];
  readonly label: string;
  readonly left: number;
  readonly top: number;
  /** Wire or socket under the finger, if it has values to show. */
  readonly about: HoverTarget | undefined;
}

export interface GraphMenu {
  readonly open: Readonly<ShallowRef<OpenMenu | undefined>>;
  /** Opens the menu for the element at a position. */
  ask(at: { clientX: number; clientY: number }, target: Element | null, isTouch: boolean): void;
  choose(action: MenuAction): void;
  /** Closes the menu and returns the focus. */
  close(): void;
}

/** State that the menu uses. */
export interface MenuSurroundings {
  readonly host: Ref<HTMLElement | null>;
  readonly editor: GraphEditor;
  readonly stage: CanvasStage;
  handle(request: MenuRequest): void;
}

const LABELS: Readonly<Record<MenuTarget['kind'], string>> = {
  nodes: 'Node actions',
  wire: 'Wire actions',
  socket: 'Socket actions',
  canvas: 'Canvas actions',
};
/** Distance of a menu opened by keyboard from the top left of the focused element, pixels. */
const KEY_INSET = 24;

/** Context menu: right click, the menu key, Shift F10; long presses call `ask` themselves. */
export function useContextMenu({ host, editor, stage, handle }: MenuSurroundings): GraphMenu {
  const open = shallowRef<OpenMenu>();
  let back: HTMLElement | null = null;

  function targetOf(found: Found): MenuTarget {
    if (found.kind !== 'node') return found;
    const nodes = nodesMeant(editor.selection.value.nodes, found.node);
    return { kind: 'nodes', nodes };
  }

  function ask(
    { clientX, clientY }: { clientX: number; clientY: number },
    element: Element | null,
    isTouch: boolean,
  ): void {
    const target = targetOf(foundAt(element));
    const entries = menuOf(editor.graph.value, target, {
      at: stage.toCanvas(clientX, clientY),
      boxOf: (id) => {
        const place = stage.positions.get(id);
        const node = editor.graph.value.nodes.get(id);
        if (place === undefined || node === undefined) return undefined;
        return { ...place, ...(stage.sizes.get(id) ?? drawnSize(node)) };
      },
      spotOn(id) {
        const wire = editor.graph.value.wires.get(id);
        const place = stage.toCanvas(clientX, clientY);
        return wire && nearestOn(spotsOnStage(stage, wire), place);
      },
      uuid: randomUuid,
      isTouch,
    });
    if (entries.length === 0) return;
    // Select the target of the menu.
    if (target.kind === 'wire') editor.selectWire(target.wire);
    else if (target.kind === 'nodes') editor.select(target.nodes);
    back = document.activeElement instanceof HTMLElement ? document.activeElement : null;
    const label = LABELS[target.kind];
    const about = isTouch ? hoverTarget(element) : undefined;
    open.value = { entries, label, left: clientX, top: clientY, about };
  }

  async function close(): Promise<void> {
    open.value = undefined;
    await nextTick();
    const isHere = back !== null && host.value?.contains(back) === true && back.isConnected;
    (isHere ? back : host.value)?.focus({ preventScroll: true });
  }

  async function choose({ command, select, request }: MenuAction): Promise<void> {
    await close();
    if (command !== undefined) editor.apply(command);
    if (select !== undefined) editor.select(select);
    if (request !== undefined) handle(request);
  }

  useEventListener(host, 'contextmenu', (event) => {
    const target = event.target instanceof Element ? event.target : null;
    // Fields and elements that float over the canvas keep the browser's menu.
    if (target?.closest('input, textarea, .floating') || !target?.closest('.graph-stage')) return;
    event.preventDefault();
    // Touch opens the menu by a long press, for which some browsers also send `contextmenu`.
    if (event instanceof PointerEvent && event.pointerType === 'touch') return;
    if (open.value !== undefined && event.button !== 2) return;
    ask(event, target, false);
  });
  useEventListener(host, 'keydown', (event) => {
    const isAsked = event.key === 'ContextMenu' || (event.key === 'F10' && event.shiftKey);
    if (!isAsked) return;
    const { activeElement } = document;
    if (activeElement === null || !host.value?.contains(activeElement)) return;
    event.preventDefault();
    event.stopPropagation();
    const element = elementMeant(activeElement);
    const { left, top } = element.getBoundingClientRect();
    ask({ clientX: left + KEY_INSET, clientY: top + KEY_INSET }, element, false);
  });

  /** With the focus on the canvas itself, the menu applies to the selection. */
  function elementMeant(active: Element): Element {
    if (active !== host.value) return active;
    const { nodes, wire } = editor.selection.value;
    const [node] = nodes;
    const mark =
      wire === undefined
        ? node === undefined
          ? undefined
          : `[data-graph-node="${CSS.escape(node)}"]`
        : `[data-wire="${CSS.escape(wire)}"]`;
    return (mark === undefined ? null : host.value.querySelector(mark)) ?? stage.container;
  }

  return { open, ask, choose: (action) => void choose(action), close: () => void close() };
}
