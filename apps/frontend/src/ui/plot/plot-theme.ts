/**
 * Colours and faces of the theme in force, as a canvas takes them. Sizes of fonts are whole pixels: uPlot
 * multiplies the digits before `px` by the device pixel ratio, and misreads a decimal point.
 */
export interface PlotTheme {
  color(token: `--${string}`): string;
  readonly font: string;
  readonly labelFont: string;
}

/** 75 % of the width: the only way a canvas font can say it. */
const STRETCH = 'condensed';

/** @param probe an element of the page that nothing else uses; its colour is changed */
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
