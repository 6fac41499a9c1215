import type { Color, Image2D, TopicRecord, Vector2 } from '@ubii/proto';

/** A value and its time of arrival, milliseconds of the page's clock. */
export interface Timed<T> {
  readonly atMs: number;
  readonly value: T;
}

/** Time span of the drawing, milliseconds. */
export const WINDOW_MS = 4_000;
/** Number of positions in a trail. */
export const TRAIL_MS = 900;

/** The values of a session's topics: the newest ones, and those of the last seconds. */
export class PreviewMemory {
  readonly #prefix: string;
  readonly #series = new Map<string, Timed<number>[]>();
  readonly #trails = new Map<string, Timed<Vector2>[]>();
  readonly #newest = new Map<string, TopicRecord>();

  /** @param prefix of the topics of the session, with a slash at its end */
  constructor(prefix: string) {
    this.#prefix = prefix;
  }

  take(record: TopicRecord, nowMs: number): void {
    if (!record.topic.startsWith(this.#prefix)) return;
    const topic = record.topic.slice(this.#prefix.length);
    this.#newest.set(topic, record);
    const number = numberOf(record);
    if (number !== undefined) keep(this.#series, topic, { atMs: nowMs, value: number }, WINDOW_MS);
    if (record.format === 'vector2') {
      keep(this.#trails, topic, { atMs: nowMs, value: record.value }, TRAIL_MS);
    }
  }

  series(topic: string): readonly Timed<number>[] {
    return this.#series.get(topic) ?? [];
  }
  trail(topic: string): readonly Timed<Vector2>[] {
    return this.#trails.get(topic) ?? [];
  }
  number(topic: string): number | undefined {
    return this.series(topic).at(-1)?.value;
  }
  position(topic: string): Vector2 | undefined {
    return this.trail(topic).at(-1)?.value;
  }
  text(topic: string): string | undefined {
    const record = this.#newest.get(topic);
    return record?.format === 'string' ? record.value : undefined;
  }
  isTrue(topic: string): boolean {
    const record = this.#newest.get(topic);
    return record?.format === 'bool' && record.value;
  }
  color(topic: string): Color | undefined {
    const record = this.#newest.get(topic);
    return record?.format === 'color' ? record.value : undefined;
  }
  picture(topic: string): Image2D | undefined {
    const record = this.#newest.get(topic);
    return record?.format === 'image2D' ? record.value : undefined;
  }
}

function numberOf(record: TopicRecord): number | undefined {
  switch (record.format) {
    case 'double':
    case 'float':
    case 'int32':
      return record.value;
    case 'bool':
      return Number(record.value);
    default:
      return undefined;
  }
}

function keep<T>(map: Map<string, Timed<T>[]>, topic: string, one: Timed<T>, forMs: number): void {
  const list = map.get(topic) ?? [];
  list.push(one);
  // Keep one value older than the window, so that a line reaches the edge.
  const first = list.findIndex(({ atMs }) => atMs >= one.atMs - forMs);
  if (first > 1) list.splice(0, first - 1);
  map.set(topic, list);
}
