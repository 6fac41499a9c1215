/** Where a tooltip stands, seen from its target. */
export type TooltipSide = 'top' | 'right' | 'bottom' | 'left';

/** What an element says in its tooltip. */
export interface TooltipText {
  readonly text: string;
  /** Keys that do the same. */
  readonly shortcut?: string | undefined;
  readonly side?: TooltipSide | undefined;
}

/** The attributes that give an element a tooltip; none without a text. */
export function tooltipAttributes(tooltip: {
  readonly text?: string | undefined;
  readonly shortcut?: string | undefined;
  readonly side?: TooltipSide | undefined;
}): Record<string, string | undefined> {
  if (!tooltip.text) return {};
  return {
    'data-tooltip': tooltip.text,
    'data-tooltip-keys': tooltip.shortcut,
    'data-tooltip-side': tooltip.side,
  };
}

/** The nearest element with a tooltip around an event's target. */
export function tooltipTarget(target: EventTarget | null): HTMLElement | undefined {
  if (!(target instanceof Element)) return undefined;
  return target.closest<HTMLElement>('[data-tooltip]') ?? undefined;
}

export function tooltipText(element: HTMLElement): TooltipText {
  const { tooltip = '', tooltipKeys, tooltipSide } = element.dataset;
  return { text: tooltip, shortcut: tooltipKeys, side: tooltipSide as TooltipSide | undefined };
}
