import { WebGLRenderer } from 'three';

/** Returns a renderer for the canvas, and its device pixel ratio. Undefined without WebGL. */
export function openRenderer(
  canvas: HTMLCanvasElement,
): { readonly renderer: WebGLRenderer; readonly ratio: number } | undefined {
  const open = (attributes: WebGLContextAttributes): WebGL2RenderingContext | null =>
    canvas.getContext('webgl2', attributes) as WebGL2RenderingContext | null;
  const fast = open({ antialias: true, failIfMajorPerformanceCaveat: true });
  const context = fast ?? open({ antialias: false });
  if (!context) return undefined;
  // With software rendering, every pixel is expensive.
  const ratio = fast ? Math.min(2, devicePixelRatio) : 1;
  return { renderer: new WebGLRenderer({ canvas, context }), ratio };
}
