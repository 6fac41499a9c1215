import { WebGLRenderer } from 'three';
import { FrameMeter, type Quality } from './quality/quality.ts';
import { StageCore } from './stage-core.ts';
import type { Stage } from './stage.ts';

export interface StageOptions {
  /** The level to begin with; measured frames change it. Default: `middle`, or `low` where the processor draws. */
  readonly quality?: Quality;
  readonly isReducedMotion?: boolean;
}

/**
 * Draws on a canvas, in its size on the page, once per animation frame, until it is disposed.
 *
 * @throws Error where the browser has no WebGL 2
 */
export function createStage(canvas: HTMLCanvasElement, options: StageOptions = {}): Stage {
  // Three.js would say so on the console as well
  if (!document.createElement('canvas').getContext('webgl2')) throw new Error('It has no WebGL 2.');
  const isFast = hasGraphicsCard();
  const core = new StageCore(
    new WebGLRenderer({ canvas, antialias: isFast, powerPreference: 'high-performance' }),
  );
  const meter = new FrameMeter(options.quality ?? (isFast ? 'middle' : 'low'));
  core.setQuality(meter.quality);
  core.setReducedMotion(options.isReducedMotion ?? false);
  const fit = (): void => core.resize(canvas.clientWidth, canvas.clientHeight);
  const sizes = new ResizeObserver(fit);
  sizes.observe(canvas);
  fit();

  let beforeMs: number | undefined;
  let request = requestAnimationFrame(function onFrame(nowMs) {
    request = requestAnimationFrame(onFrame);
    if (beforeMs !== undefined) meter.take(nowMs - beforeMs);
    beforeMs = nowMs;
    core.setQuality(meter.quality);
    core.advance(performance.now());
    core.draw();
  });

  return {
    show(scene) {
      // Building a new scene takes time that says nothing about the device
      if (core.show(scene, performance.now())) meter.restart();
    },
    setReducedMotion: (isReduced) => core.setReducedMotion(isReduced),
    placeOf: (seat) => core.placeOf(seat),
    get frames() {
      return { p95Ms: meter.p95Ms, quality: meter.quality };
    },
    dispose() {
      cancelAnimationFrame(request);
      sizes.disconnect();
      core.dispose();
    },
  };
}

/** Whether WebGL draws without a major loss of speed: a canvas of its own is asked, whose answer binds nothing. */
function hasGraphicsCard(): boolean {
  const attributes = { failIfMajorPerformanceCaveat: true };
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl2', attributes) as WebGL2RenderingContext | null;
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return context !== null;
}
