import type { Box } from './stage-view.ts';

/** Element of the graph under a pointer. */
export type Thing =
  | { readonly kind: 'node' | 'frame'; readonly id: string }
  | { readonly kind: 'wire'; readonly id: string };

/** Returns the node, frame, wire or socket that a DOM element belongs to; undefined: empty canvas. */
export function thingAt(target: EventTarget | null): Thing | undefined {
  const element = target instanceof Element ? target : undefined;
  const node = element?.closest<HTMLElement>('[data-graph-node]');
  const id = node?.dataset['graphNode'];
  if (node && id !== undefined)
    return { kind: node.classList.contains('frame') ? 'frame' : 'node', id };
  const wire = element?.closest<HTMLElement>('[data-wire], [data-wire-chip]');
  const { wire: own, wireChip } = wire?.dataset ?? {};
  const wireId = own ?? wireChip;
  return wireId === undefined ? undefined : { kind: 'wire', id: wireId };
}

interface ClientPoint {
  readonly clientX: number;
  readonly clientY: number;
}

/** Returns the box between two page positions, in pixels relative to an element. */
export function onPage(element: HTMLElement, a: ClientPoint, b: ClientPoint): Box {
  const { left, top } = element.getBoundingClientRect();
  return {
    x: Math.min(a.clientX, b.clientX) - left,
    y: Math.min(a.clientY, b.clientY) - top,
    width: Math.abs(b.clientX - a.clientX),
    height: Math.abs(b.clientY - a.clientY),
  };
}
