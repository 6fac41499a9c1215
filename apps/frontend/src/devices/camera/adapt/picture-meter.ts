/** What was measured of one picture that left. */
export interface SentPicture {
  /** When it was published, milliseconds. */
  readonly atMs: number;
  readonly bytes: number;
  readonly encodeMs: number;
  /** From publishing until the system had taken its bytes, milliseconds. */
  readonly leaveMs: number;
}

/** Pictures of the last seconds, in figures. */
export interface SentSummary {
  /** Medians. */
  readonly bytes: number;
  readonly encodeMs: number;
  readonly leaveMs: number;
  readonly rateHz: number;
  /** Bytes that left per second, over the whole time. */
  readonly bytesPerSecond: number;
}

/** Enough to see a trend, few enough to follow it, milliseconds. */
const WINDOW_MS = 2000;
/** Slow pictures count for longer. */
const MIN_PICTURES = 3;

/** The pictures that left lately. */
export class PictureMeter {
  #pictures: SentPicture[] = [];

  note(picture: SentPicture): void {
    this.#pictures.push(picture);
    while (
      this.#pictures.length > MIN_PICTURES &&
      this.#pictures[0]!.atMs < picture.atMs - WINDOW_MS
    ) {
      this.#pictures.shift();
    }
  }

  /** Settings changed: what was measured before says nothing any more. */
  clear(): void {
    this.#pictures = [];
  }

  /** `undefined` until there are enough pictures. */
  summary(): SentSummary | undefined {
    const pictures = this.#pictures;
    const [first] = pictures;
    const last = pictures.at(-1);
    if (pictures.length < MIN_PICTURES || first === undefined || last === undefined)
      return undefined;
    const seconds = (last.atMs - first.atMs) / 1000;
    const bytes = pictures.slice(0, -1).reduce((sum, picture) => sum + picture.bytes, 0);
    return {
      bytes: median(pictures.map((picture) => picture.bytes)),
      encodeMs: median(pictures.map((picture) => picture.encodeMs)),
      leaveMs: median(pictures.map((picture) => picture.leaveMs)),
      rateHz: (pictures.length - 1) / seconds,
      bytesPerSecond: bytes / seconds,
    };
  }
}

function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)]!;
}
