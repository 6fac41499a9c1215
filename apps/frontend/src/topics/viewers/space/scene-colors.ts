import { plotTheme } from '../../../ui/plot/plot-theme.ts';
import type { SceneColors } from './three/scene-input.ts';

/** Reads the colours of the current theme. @param probe element without other uses */
export function sceneColors(probe: HTMLElement): SceneColors {
  const { color } = plotTheme(probe);
  return {
    ground: color('--canvas'),
    grid: color('--line-2'),
    axis: color('--control'),
    arms: [color('--family-rotation'), color('--space-arm-y'), color('--space-arm-z')],
    vector: color('--family-vector'),
    box: color('--family-objects'),
  };
}
