import { ServiceError, type RecordingMarker, type TextLimits } from '@ubii/proto';
import { oneLine, shortened } from '@ubii/words';
import type { Marker, RecordingEvent } from '../records/recording-event.ts';
import type { MarkerJob } from './recorder.ts';
import { nsOf } from '../records/recorded-record.ts';

/** Markers of one recording. [RC-20] */
export class MarkerList {
  readonly #markers: Map<string, Marker>;
  readonly #max: number;
  #changes: number;

  constructor(markers: readonly Marker[], max: number) {
    this.#markers = new Map(markers.map((marker) => [marker.id, marker]));
    this.#max = max;
    this.#changes = markers.length;
  }

  get size(): number {
    return this.#markers.size;
  }

  /** By time. */
  values(): readonly Marker[] {
    return [...this.#markers.values()].sort((a, b) => a.timeMs - b.timeMs);
  }

  /**
   * Adds, changes or removes a marker.
   *
   * @returns the event for the file
   * @throws ServiceError when it is a marker of others, or there are too many
   */
  apply({ marker: wanted, kind = 'service', mayChangeAll }: MarkerJob): RecordingEvent<'marker'> {
    const before = this.#markers.get(wanted.id);
    if (before !== undefined && !mayChangeAll && before.authorId !== wanted.clientId) {
      throw new ServiceError(
        'permission_denied', // [RC-21]
        'This marker is of another client. Only the maker of the recording and admins may change it.',
      );
    }
    if (this.#changes >= this.#max) throw tooMany(this.#max);
    this.#changes++;
    const { id, timeMs, text, isRemoved } = wanted;
    const made = before ?? { author: wanted.author, authorId: wanted.clientId, kind };
    const marker: Marker = { ...made, id, timeMs, text, isRemoved };
    if (isRemoved) this.#markers.delete(id);
    else this.#markers.set(id, marker);
    return { kind: 'marker', timeNs: nsOf(timeMs), value: marker };
  }
}

/** A marker as services describe it. [RC-54] */
export function describeMarker(
  recordingId: string,
  { id, timeMs, text, author, authorId, isRemoved = false }: Marker,
  { eventCharacters, nameCharacters }: TextLimits,
): RecordingMarker {
  return {
    recordingId,
    id,
    timeMs,
    clientId: authorId,
    isRemoved,
    text: shortened(text, eventCharacters),
    author: shortened(oneLine(author, nameCharacters + 1), nameCharacters),
  };
}

/** [RC-23] */
function tooMany(max: number): ServiceError {
  return new ServiceError(
    'resource_exhausted',
    `This recording has ${max} markers, which is the limit markersPerRecording of this master.`,
    { details: { limit: 'markersPerRecording', max } },
  );
}
