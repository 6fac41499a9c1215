import { WebGLRenderer } from 'three';

/**
 * What draws on the canvas, and how many pixels it draws for one of the page. Undefined where there is
 * no WebGL.
 */
export function openRenderer(
  canvas: HTMLCanvasElement,
): { readonly renderer: WebGLRenderer; readonly ratio: number } | undefined {
  const open = (attributes: WebGLContextAttributes): WebGL2RenderingContext | null =>
    canvas.getContext('webgl2', attributes) as WebGL2RenderingContext | null;
  const fast = open({ antialias: true, failIfMajorPerformanceCaveat: true });
  const context = fast ?? open({ antialias: false });
  if (!context) return undefined;
  // Every pixel costs where the processor draws them.
  const ratio = fast ? Math.min(2, devicePixelRatio) : 1;
  return { renderer: new WebGLRenderer({ canvas, context }), ratio };
}
