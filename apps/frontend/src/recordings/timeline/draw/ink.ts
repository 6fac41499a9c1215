import { plotTheme } from '../../../ui/plot/plot-theme.ts';
import type { TrackInk } from './track-canvas.ts';

/** Colours of the theme in force, each asked for once. @param probe an element that nothing else uses; its colour is changed */
export function trackInk(probe: HTMLElement): TrackInk {
  const known = new Map<string, string>();
  return {
    color(css) {
      let color = known.get(css);
      if (color === undefined) {
        probe.style.color = css;
        known.set(css, (color = getComputedStyle(probe).color));
      }
      return color;
    },
    font: plotTheme(probe).labelFont,
  };
}
