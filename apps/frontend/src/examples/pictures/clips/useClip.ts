import { systemClock } from '@ubii/client-web';
import { computed, onScopeDispose, shallowRef, watch } from 'vue';
import { pictureClock } from '../../../devices/camera/picture-clock.ts';
import type { Clip } from './clip.ts';
import { CLIPS, type ClipName } from './clips.ts';

const RATE_HZ = 30;
const SIZE = { width: 960, height: 540 };

/** Draws a built-in clip on a canvas, while the calling scope is active. */
export function useClip(
  first: ClipName,
  options: {
    readonly isShown: () => boolean;
    /** The clip continues while another tab is in front. */
    readonly isSent: () => boolean;
    readonly onDrawn: () => void;
  },
) {
  const name = shallowRef(first);
  const canvas = Object.assign(document.createElement('canvas'), SIZE);
  const loaded = shallowRef<ReadonlyMap<ClipName, Clip>>(new Map());
  const loading = new Set<ClipName>();
  let timeMs = 0;

  function draw(): void {
    const clip = loaded.value.get(name.value);
    if (!clip) return;
    timeMs += 1000 / RATE_HZ;
    options.onDrawn();
    clip.draw(canvas, timeMs);
  }
  function load(wanted: ClipName): void {
    if (loading.has(wanted)) return;
    loading.add(wanted);
    CLIPS[wanted].load().then(
      (clip) => (loaded.value = new Map(loaded.value).set(wanted, clip)),
      () => loading.delete(wanted), // The master is disconnected, which the shell shows.
    );
  }
  watch(
    [name, options.isShown, options.isSent],
    ([wanted, isShown, isSent], _before, onCleanup) => {
      if (!isShown) return;
      onCleanup((isSent ? pictureClock : systemClock).every(1000 / RATE_HZ, draw));
      load(wanted);
    },
    { immediate: true },
  );
  onScopeDispose(() => {
    for (const clip of loaded.value.values()) clip.close?.();
  });
  return {
    name,
    /** Undefined until the clip is loaded. */
    canvas: computed(() => (loaded.value.has(name.value) ? canvas : undefined)),
  };
}
