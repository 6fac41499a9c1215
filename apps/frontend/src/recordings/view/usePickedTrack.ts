import { computed, shallowRef, type ComputedRef, type WritableComputedRef } from 'vue';
import type { Track } from '../timeline/track.ts';
import { useTimeline } from './useTimeline.ts';

/**
 * One of the tracks of a stage: the chosen one, else that of the inspector, else the first.
 *
 * @param fits returns those to choose from
 * @param leads whether it follows the inspector to a track; to each by default
 */
export function usePickedTrack(
  fits: (tracks: readonly Track[]) => readonly Track[],
  leads: (track: Track) => boolean = () => true,
): {
  readonly tracks: ComputedRef<readonly Track[]>;
  readonly track: ComputedRef<Track | undefined>;
  readonly topic: WritableComputedRef<string>;
} {
  const timeline = useTimeline();
  const picked = shallowRef('');
  const tracks = computed(() => fits(timeline.tracks.value));
  const track = computed(() => {
    const selected = timeline.selected.value?.topic;
    return (
      tracks.value.find(({ topic }) => topic === picked.value) ??
      tracks.value.find((one) => one.topic === selected && leads(one)) ??
      tracks.value[0]
    );
  });
  const topic = computed({
    get: () => track.value?.topic ?? '',
    set: (next) => (picked.value = next),
  });
  return { tracks, track, topic };
}
