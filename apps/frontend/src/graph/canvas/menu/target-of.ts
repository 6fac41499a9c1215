import type { PortRef } from '../../model/graph.ts';

/** Element of the graph under a pointer, by `data` attributes of the views. */
export type Found =
  | { readonly kind: 'node'; readonly node: string }
  | { readonly kind: 'wire'; readonly wire: string }
  | { readonly kind: 'socket'; readonly port: PortRef }
  | { readonly kind: 'canvas' };

/** @param element under the pointer, or with the focus */
export function foundAt(element: Element | null): Found {
  const socket = element?.closest<HTMLElement>('[data-port]')?.dataset;
  if (socket?.['node'] !== undefined && socket['port'] !== undefined)
    return { kind: 'socket', port: { node: socket['node'], port: socket['port'] } };
  const wire = element?.closest<HTMLElement>('[data-wire], [data-wire-chip]')?.dataset;
  const id = wire?.['wire'] ?? wire?.['wireChip'];
  if (id !== undefined) return { kind: 'wire', wire: id };
  const node = element?.closest<HTMLElement>('[data-graph-node]')?.dataset['graphNode'];
  return node === undefined ? { kind: 'canvas' } : { kind: 'node', node };
}
