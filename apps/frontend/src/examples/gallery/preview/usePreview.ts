import { ButtonEventType, type RecordInit } from '@ubii/proto';
import { systemClock } from '@ubii/timing/system';
import {
  useDocumentVisibility,
  useElementVisibility,
  useEventListener,
  usePreferredReducedMotion,
} from '@vueuse/core';
import { computed, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import type { GalleryEntry } from '../gallery.ts';
import type { InputName } from '../inputs/input-names.ts';
import { DEMO_INTERVAL_MS, demoInputs } from './demo-input.ts';
import { previewFrame, type PreviewFrame } from './preview-frame.ts';
import type { PreviewKit } from './preview-kit.ts';
import { PreviewMemory } from './preview-memory.ts';
import { PreviewRun } from './preview-run.ts';

/** Maximum frame rate: enough for a drawing of this size. */
const FRAME_MS = 1000 / 31;
/** With reduced motion, only one frame is drawn, after this time. */
const STILL_AFTER_MS = 2_000;

const ignore = (): void => undefined;

/**
 * Runs the preview of an example while `element` is in view. A pointer over the element, clicks and keys
 * replace the demonstration input.
 */
export function usePreview(
  entry: GalleryEntry,
  element: Readonly<ShallowRef<HTMLElement | null>>,
  loadKit: () => Promise<PreviewKit>,
): {
  readonly frame: Readonly<ShallowRef<PreviewFrame | undefined>>;
  readonly isPointed: Ref<boolean>;
} {
  const frame = shallowRef<PreviewFrame>();
  const isPointed = shallowRef(false);
  const isInView = useElementVisibility(element);
  const visibility = useDocumentVisibility();
  const motion = usePreferredReducedMotion();
  const isStill = computed(() => motion.value === 'reduce');
  let put: (record: RecordInit) => void = () => undefined;

  watch(
    () => [isInView.value && visibility.value === 'visible', isStill.value] as const,
    async ([isWanted, still], _before, onCleanup) => {
      if (!isWanted) return;
      const ends: (() => void)[] = [];
      let isOver = false;
      const end = (): void => {
        isOver = true;
        put = () => undefined;
        for (const one of ends) one();
      };
      onCleanup(end);
      const kit = await loadKit();
      const session = kit.session(entry);
      const patterns = await kit.patterns(session);
      if (isOver) return;

      const memory = new PreviewMemory(`/examples/${entry.id}/`);
      const world = { sandboxes: kit.sandboxes, patterns, clock: systemClock };
      const run = new PreviewRun(session, kit.library, world, (record) =>
        memory.take(record, performance.now()),
      );
      ends.push(() => void run.close().catch(ignore));
      try {
        await run.start();
      } catch (error) {
        // The page was closed while modules started.
        if (!isOver) throw error;
      }
      if (isOver) return;
      put = (record) => run.put(record);

      let fromMs = 0;
      const startMs = performance.now();
      ends.push(
        systemClock.every(DEMO_INTERVAL_MS, () => {
          const toMs = performance.now() - startMs;
          if (!isPointed.value) demoInputs(entry, fromMs, toMs).forEach(put);
          fromMs = toMs;
        }),
      );
      const draw = (): void => {
        frame.value = previewFrame(entry.view, memory, performance.now());
      };
      if (still) {
        ends.push(
          systemClock.after(STILL_AFTER_MS, () => {
            draw();
            end();
          }),
        );
        return;
      }
      let drawnMs = 0;
      let request = requestAnimationFrame(function next(nowMs) {
        request = requestAnimationFrame(next);
        if (nowMs - drawnMs < FRAME_MS) return;
        drawnMs = nowMs;
        draw();
      });
      ends.push(() => cancelAnimationFrame(request));
    },
    { immediate: true, flush: 'post' },
  );

  const topicOf = (name: InputName): string | undefined =>
    entry.inputs.find(({ input }) => input === name)?.topic;
  function putBool(name: InputName, value: boolean): void {
    const topic = topicOf(name);
    if (topic !== undefined) put({ topic, format: 'bool', value });
  }
  useEventListener(element, ['pointerenter', 'pointermove'], (event: PointerEvent) => {
    if (entry.inputs.length === 0) return;
    isPointed.value = true;
    const topic = topicOf('pointer');
    const box = element.value?.getBoundingClientRect();
    if (topic === undefined || box === undefined) return;
    const value = {
      x: (event.clientX - box.left) / box.width,
      y: (event.clientY - box.top) / box.height,
    };
    put({ topic, format: 'vector2', value });
  });
  useEventListener(element, 'pointerdown', () => putBool('pressed', true));
  useEventListener(element, ['pointerup', 'pointercancel'], () => putBool('pressed', false));
  useEventListener(element, ['pointerleave', 'pointercancel'], () => (isPointed.value = false));
  useEventListener(window, ['keydown', 'keyup'], (event: KeyboardEvent) => {
    if (!isPointed.value || event.repeat) return;
    const isDown = event.type === 'keydown';
    if (event.key === 'Escape') putBool('escape', isDown);
    const topic = topicOf('key');
    if (topic === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    const type = isDown ? ButtonEventType.DOWN : ButtonEventType.UP;
    put({ topic, format: 'keyEvent', value: { type, key: event.key } });
  });

  return { frame, isPointed };
}
