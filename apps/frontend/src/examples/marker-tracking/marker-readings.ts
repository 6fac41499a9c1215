import type { Object3D, TopicRecord } from '@ubii/proto';

/** Results of the module for one picture. */
export interface MarkerReading {
  readonly markers: readonly Object3D[];
  readonly outlines: TopicRecord;
}

/** Most pictures with incomplete results. */
const MAX_PARTS = 4;

/** Joins the outputs of a run, which arrive as separate records, by the timestamp of the picture. */
export class MarkerReadings {
  #parts = new Map<number | undefined, Partial<MarkerReading>>();

  /** @returns the reading when it is complete */
  take(
    takenMs: number | undefined,
    part: Pick<MarkerReading, 'markers'> | Pick<MarkerReading, 'outlines'>,
  ): MarkerReading | undefined {
    const { markers, outlines } = {
      ...this.#parts.get(takenMs),
      ...part,
    } as Partial<MarkerReading>;
    this.#parts.delete(takenMs);
    if (markers && outlines) return { markers, outlines };
    this.#parts.set(takenMs, part);
    if (this.#parts.size > MAX_PARTS) this.#parts.delete(this.#parts.keys().next().value);
    return undefined;
  }

  clear(): void {
    this.#parts.clear();
  }
}
