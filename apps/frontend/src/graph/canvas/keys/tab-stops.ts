const TABBABLE = 'a[href], button, input, select, textarea, [tabindex]';

/** Returns the tabbable elements within an element, in order. */
export function tabStops(root: Element): HTMLElement[] {
  return [...root.querySelectorAll<HTMLElement>(TABBABLE)].filter(
    (element) =>
      element.tabIndex >= 0 && !element.matches(':disabled') && element.getClientRects().length > 0,
  );
}

/**
 * Returns the target of Tab on a canvas: the canvas is one stop, and fields are reached from their node. Undefined: the
 * browser decides.
 * @param host the canvas with the tools that float over it
 * @param stage the element with the nodes
 * @param current the node that has, or had, the focus
 */
export function nextStop(
  { host, stage, current }: { host: HTMLElement; stage: Element; current: Element | null },
  element: HTMLElement,
  isBack: boolean,
): HTMLElement | undefined {
  const tools = tabStops(host).filter((one) => !stage.contains(one));
  const node = element.closest<HTMLElement>('[data-graph-node]');
  if (node === null || !stage.contains(node)) {
    if (element === host) return isBack ? undefined : tools[0];
    if (!isBack || element !== tools[0]) return undefined;
    return current instanceof HTMLElement ? current : host;
  }
  const own = [node, ...tabStops(node)];
  const at = Math.max(0, own.indexOf(element));
  if (isBack) return own[at - 1] ?? host;
  return own[at + 1] ?? tools[0];
}
