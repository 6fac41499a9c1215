/**
 * Colours and fonts of the current theme, for a canvas. Font sizes are integers: uPlot multiplies the digits before
 * `px` by the device pixel ratio, and misreads a decimal point.
 */
export interface PlotTheme {
  color(token: `--${string}`): string;
  readonly font: string;
  readonly labelFont: string;
}

/** Keyword for a width of 75 %: canvas fonts support no percentages. */
const STRETCH = 'condensed';

/** @param probe element without other uses; its colour is changed */
export function plotTheme(probe: HTMLElement): PlotTheme {
  const style = getComputedStyle(probe);
  const face = (token: string): string => style.getPropertyValue(token).trim() || 'sans-serif';
  return {
    color(token) {
      probe.style.color = `var(${token})`;
      return getComputedStyle(probe).color;
    },
    font: `${STRETCH} 11px ${face('--font-mono')}`,
    labelFont: `11px ${face('--font-ui')}`,
  };
}
