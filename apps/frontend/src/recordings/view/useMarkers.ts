import { RecordingState, type Recording } from '@ubii/proto';
import { shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { useRecordings } from '../list/useRecordings.ts';
import type { OpenedPlayer } from '../opened/opened-player.ts';
import type { PlacedMarker } from '../reading/recording-messages.ts';

/** The markers of an opened recording, which people add, rename and remove. */
export interface Markers {
  readonly list: Readonly<ShallowRef<readonly PlacedMarker[]>>;
  /** @returns the new one; undefined when the master refused it */
  add(timeMs: number): Promise<PlacedMarker | undefined>;
  rename(marker: PlacedMarker, text: string): Promise<void>;
  remove(marker: PlacedMarker): Promise<void>;
}

/** @param recording at the master; undefined for a file of this device, which stays as it is */
export function useMarkers(
  opened: OpenedPlayer,
  recording: Readonly<Ref<Recording | undefined>>,
): Markers {
  const recordings = useRecordings();
  const list = shallowRef<readonly PlacedMarker[]>([]);
  watch(opened.recording, (now) => (list.value = now?.markers ?? []), { immediate: true });

  const put = (marker: PlacedMarker): void => {
    const others = list.value.filter(({ id }) => id !== marker.id);
    list.value = [...others, marker].sort((a, b) => a.timeMs - b.timeMs);
  };
  /** Tells the master. @returns the marker as the master has it */
  async function tell(
    marker: Partial<PlacedMarker>,
    isRemoved: boolean,
  ): Promise<PlacedMarker | undefined> {
    const at = opened.recording.value;
    if (recording.value === undefined || at === undefined) return undefined;
    const reply = await recordings.mark({
      recordingId: recording.value.id,
      id: marker.id ?? '',
      timeMs: at.startMs + (marker.timeMs ?? 0),
      text: marker.text ?? '',
      isRemoved,
    });
    if (reply === undefined) return undefined;
    const { id, timeMs, text, author } = reply;
    return { id, text, author, timeMs: timeMs - at.startMs };
  }
  return {
    list,
    async add(timeMs) {
      const added = await tell({ timeMs }, false);
      if (added) put(added);
      return added;
    },
    async rename(marker, text) {
      const renamed = await tell({ ...marker, text }, false);
      if (renamed) put(renamed);
    },
    async remove(marker) {
      const removed = await tell(marker, true);
      if (removed) list.value = list.value.filter(({ id }) => id !== marker.id);
    },
  };
}

/** Why markers of a recording cannot be changed; undefined when they can. */
export function markRefusal(
  recording: Recording | undefined,
  mayRecord = true,
): string | undefined {
  if (recording === undefined) return 'Upload the file to the master to add markers.';
  if (!mayRecord) return 'Participants and admins can add markers.';
  return recording.state === RecordingState.RECORDING_STATE_RECORDING
    ? 'Stop the recording first.'
    : undefined;
}
