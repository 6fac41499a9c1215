import type { Size } from '../model/graph.ts';

/** Returns the position at which a box is entirely inside an element, pixels. */
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
