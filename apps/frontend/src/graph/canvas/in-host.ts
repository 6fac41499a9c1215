import type { Size } from '../model/graph.ts';

/** Where something of a size stands in an element so that all of it is seen, pixels. */
export function inHost(
  element: HTMLElement,
  clientX: number,
  clientY: number,
  size: Size,
): { left: number; top: number } {
  const { left, top, width, height } = element.getBoundingClientRect();
  return {
    left: Math.max(8, Math.min(clientX - left, width - size.width)),
    top: Math.max(8, Math.min(clientY - top, height - size.height)),
  };
}
