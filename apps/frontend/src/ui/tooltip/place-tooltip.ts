import type { TooltipSide } from './tooltip-target.ts';

interface Box {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

const GAP = 6;
const EDGE = 8;

const OPPOSITE: Readonly<Record<TooltipSide, TooltipSide>> = {
  top: 'bottom',
  bottom: 'top',
  left: 'right',
  right: 'left',
};

function at(target: Box, size: { width: number; height: number }, side: TooltipSide) {
  const middleX = target.left + (target.width - size.width) / 2;
  const middleY = target.top + (target.height - size.height) / 2;
  switch (side) {
    case 'top':
      return { left: middleX, top: target.top - size.height - GAP };
    case 'bottom':
      return { left: middleX, top: target.top + target.height + GAP };
    case 'left':
      return { left: target.left - size.width - GAP, top: middleY };
    case 'right':
      return { left: target.left + target.width + GAP, top: middleY };
  }
}

/** Returns the position of a tooltip in viewport pixels: on its side, otherwise opposite, always inside. */
export function placeTooltip(
  target: Box,
  size: { readonly width: number; readonly height: number },
  viewport: { readonly width: number; readonly height: number },
  side: TooltipSide,
): { left: number; top: number } {
  const fits = ({ left, top }: { left: number; top: number }): boolean =>
    side === 'top' || side === 'bottom'
      ? top >= EDGE && top + size.height <= viewport.height - EDGE
      : left >= EDGE && left + size.width <= viewport.width - EDGE;
  const wanted = at(target, size, side);
  const { left, top } = fits(wanted) ? wanted : at(target, size, OPPOSITE[side]);
  return {
    left: Math.max(EDGE, Math.min(left, viewport.width - size.width - EDGE)),
    top: Math.max(EDGE, Math.min(top, viewport.height - size.height - EDGE)),
  };
}
