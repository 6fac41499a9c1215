import { plotTheme } from '../../../ui/plot/plot-theme.ts';
import type { SceneColors } from './three/scene-input.ts';

/** The colours of the theme in force. @param probe an element that nothing else uses */
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
