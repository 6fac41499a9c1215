/** Side of its target on which a tooltip is shown. */
export type TooltipSide = 'top' | 'right' | 'bottom' | 'left';

/** Text of a tooltip. */
export interface TooltipText {
  readonly text: string;
  /** Keyboard shortcut. */
  readonly shortcut?: string | undefined;
  readonly side?: TooltipSide | undefined;
}

/** Attributes that give an element a tooltip; empty without a text. */
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

/** Returns the nearest element with a tooltip around an event's target. */
export function tooltipTarget(target: EventTarget | null): HTMLElement | undefined {
  if (!(target instanceof Element)) return undefined;
  return target.closest<HTMLElement>('[data-tooltip]') ?? undefined;
}

export function tooltipText(element: HTMLElement): TooltipText {
  const { tooltip = '', tooltipKeys, tooltipSide } = element.dataset;
  return { text: tooltip, shortcut: tooltipKeys, side: tooltipSide as TooltipSide | undefined };
}
