/** Measurements of a sent picture. */
export interface SentPicture {
  /** Time of publishing, milliseconds. */
  readonly atMs: number;
  readonly bytes: number;
  readonly encodeMs: number;
  /** Time from publishing until the operating system accepted its bytes, milliseconds. */
  readonly leaveMs: number;
}

/** Statistics of the pictures of the last seconds. */
export interface SentSummary {
  /** Medians. */
  readonly bytes: number;
  readonly encodeMs: number;
  readonly leaveMs: number;
  readonly rateHz: number;
  /** Bytes sent per second, over the whole window. */
  readonly bytesPerSecond: number;
}

/** Long enough for a stable result, short enough to react, milliseconds. */
const WINDOW_MS = 2000;
/** Slow pictures count beyond the window, up to this number. */
const MIN_PICTURES = 3;

/** Recently sent pictures. */
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

  /** Drops all measurements after a change of settings. */
  clear(): void {
    this.#pictures = [];
  }

  /** Returns `undefined` until there are enough pictures. */
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
