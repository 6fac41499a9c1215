import { useDocumentVisibility, useElementSize, useElementVisibility } from '@vueuse/core';
import { computed, onScopeDispose, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import type { SceneLabel } from './three/scene-input.ts';

/** State of the scene, or the reason why nothing is drawn. */
export type SceneState = 'loading' | 'drawn' | 'missing' | 'lost' | 'failed';

/** Draws its input on a canvas. */
export interface DrawnScene<Input> {
  resize(width: number, height: number): void;
  /** @returns labels with their positions */
  draw(input: Input): readonly SceneLabel[];
  dispose(): void;
}

/** Creates a scene on a canvas; undefined without WebGL. */
export interface SceneOpener<Input> {
  open(canvas: HTMLCanvasElement): DrawnScene<Input> | undefined;
}

/**
 * Maintains a 3D view: draws after changes while the canvas is visible.
 * @param load loads the scene on first use, because it is large
 */
export function useSpaceScene<Input>(
  canvas: Readonly<Ref<HTMLCanvasElement | null>>,
  frame: Readonly<Ref<HTMLElement | null>>,
  input: () => Input | undefined,
  load: () => Promise<SceneOpener<Input>>,
): {
  readonly state: Readonly<ShallowRef<SceneState>>;
  readonly labels: Readonly<ShallowRef<readonly SceneLabel[]>>;
  /** True while the canvas is visible. */
  readonly isSeen: Readonly<Ref<boolean>>;
  /** Requests a new frame. */
  redraw(): void;
  /** Retries after the context was lost; needs a new canvas. */
  close(): void;
} {
  const state = shallowRef<SceneState>('loading');
  const labels = shallowRef<readonly SceneLabel[]>([]);
  const { width, height } = useElementSize(frame);
  const isInView = useElementVisibility(frame);
  const visibility = useDocumentVisibility();
  const isSeen = computed(() => isInView.value && visibility.value === 'visible');
  let scene: DrawnScene<Input> | undefined;
  let requested: number | undefined;
  let opening = 0;

  function draw(): void {
    requested = undefined;
    const next = input();
    if (!scene || !next || state.value === 'lost') return;
    labels.value = scene.draw(next);
    state.value = 'drawn';
  }
  function redraw(): void {
    if (isSeen.value && scene) requested ??= requestAnimationFrame(draw);
  }
  function close(): void {
    opening += 1;
    if (requested !== undefined) cancelAnimationFrame(requested);
    requested = undefined;
    scene?.dispose();
    scene = undefined;
    labels.value = [];
  }

  watch(
    canvas,
    async (element, _before, onCleanup) => {
      close();
      if (!element) return;
      state.value = 'loading';
      const mine = opening;
      element.addEventListener('webglcontextlost', (event) => {
        // Otherwise the browser does not restore the context.
        event.preventDefault();
        if (mine === opening) state.value = 'lost';
      });
      element.addEventListener('webglcontextrestored', () => {
        if (mine !== opening) return;
        state.value = 'loading';
        redraw();
      });
      onCleanup(() => mine === opening && close());
      try {
        const loaded = await load();
        if (mine !== opening) return;
        scene = loaded.open(element);
      } catch {
        state.value = 'failed';
        return;
      }
      if (!scene) state.value = 'missing';
      else scene.resize(Math.floor(width.value), Math.floor(height.value));
      redraw();
    },
    { immediate: true, flush: 'post' },
  );
  watch([width, height], () => {
    if (width.value === 0 || height.value === 0) return;
    scene?.resize(Math.floor(width.value), Math.floor(height.value));
    redraw();
  });
  watch(isSeen, redraw);
  onScopeDispose(close);

  return { state, labels, isSeen, redraw, close };
}
