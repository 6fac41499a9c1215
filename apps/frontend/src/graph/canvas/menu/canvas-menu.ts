import type { Graph } from '../../model/graph.ts';
import { commentNode } from '../../model/make-node.ts';
import { onGrid } from '../free-spot.ts';
import { action, separated, type MenuEntry, type MenuPlace } from './menu-entry.ts';

/** Returns the menu entries for empty canvas. */
export function canvasMenu(graph: Graph, { at, uuid, isTouch }: MenuPlace): MenuEntry[] {
  const note = commentNode(`comment:${uuid()}`, '', { position: onGrid(at) });
  const nodes = [...graph.nodes.keys()];
  const isEmpty = nodes.length === 0;
  return separated(
    [
      action('Add node…', { request: { kind: 'add', at } }, { shortcut: 'A' }),
      action('Add note', {
        command: { kind: 'add', nodes: [note] },
        select: [note.id],
        request: { kind: 'inspect', node: note.id },
      }),
      action('Paste', { request: { kind: 'paste', at } }, { shortcut: 'Ctrl V' }),
    ],
    isEmpty
      ? []
      : [
          action('Select all', { request: { kind: 'select', nodes } }, { shortcut: 'Ctrl A' }),
          ...(isTouch ? [action('Select multiple', { request: { kind: 'selectMore' } })] : []),
        ],
    isEmpty
      ? []
      : [
          action('Arrange all', { request: { kind: 'arrange' } }),
          action('Zoom to fit', { request: { kind: 'fit' } }, { shortcut: 'F' }),
          action('Find…', { request: { kind: 'find' } }, { shortcut: 'Ctrl F' }),
        ],
  );
}
