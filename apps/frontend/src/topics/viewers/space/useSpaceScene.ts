import { useDocumentVisibility, useElementSize, useElementVisibility } from '@vueuse/core';
import { computed, onScopeDispose, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import type { SceneLabel } from './three/scene-input.ts';

/** Whether there is a picture, and if not, why. */
export type SceneState = 'loading' | 'drawn' | 'missing' | 'lost' | 'failed';

/** Draws on a canvas what it is told to. */
export interface DrawnScene<Input> {
  resize(width: number, height: number): void;
  /** @returns what is to be written where */
  draw(input: Input): readonly SceneLabel[];
  dispose(): void;
}

/** How a scene comes onto a canvas; undefined where there is no WebGL. */
export interface SceneOpener<Input> {
  open(canvas: HTMLCanvasElement): DrawnScene<Input> | undefined;
}

/**
 * Keeps a 3D view on a canvas: drawn when something changed and the canvas is visible.
 * @param load the scene, which is large and comes only when it is needed
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
  /** Something changed. */
  redraw(): void;
  /** Another attempt after the picture was lost; the canvas has to be a new one. */
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
      const attempt = opening;
      element.addEventListener('webglcontextlost', (event) => {
        // Else the browser never gives it back
        event.preventDefault();
        if (attempt === opening) state.value = 'lost';
      });
      element.addEventListener('webglcontextrestored', () => {
        if (attempt !== opening) return;
        state.value = 'loading';
        redraw();
      });
      onCleanup(() => attempt === opening && close());
      try {
        const loaded = await load();
        if (attempt !== opening) return;
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
