import type { Clock } from '@ubii/timing';
import type { TopicEntry } from '../topics/topic-entry.ts';
import type { TopicTable } from '../topics/topic-table.ts';

/** Measurements that are kept. */
const MAX_SAMPLES = 12;
/** Shortest time over which a rate is measured, milliseconds: timers of the last second come late. */
const MIN_SPAN_MS = 900;
/** A measurement that is older says nothing of now, milliseconds. */
const MAX_AGE_MS = 2_500;

interface Sample {
  /** Monotonic. */
  readonly timeMs: number;
  readonly records: ReadonlyMap<TopicEntry, number>;
}

/** Rates of topics, from counts once a second while they are needed. */
export class RateMeter {
  readonly #clock: Clock;
  readonly #topics: TopicTable;
  #samples: Sample[] = [];

  constructor(clock: Clock, topics: TopicTable) {
    this.#clock = clock;
    this.#topics = topics;
  }

  /** Whether there are rates of now. */
  get isReady(): boolean {
    const newest = this.#samples.at(-1);
    return this.#samples.length > 1 && this.#isRecent(newest);
  }

  /** Counts the records of all topics. */
  measure(): void {
    const timeMs = this.#clock.monotonicMs();
    const newest = this.#samples.at(-1);
    if (!this.#isRecent(newest)) this.#samples = [];
    else if (timeMs - newest!.timeMs < MIN_SPAN_MS) return;
    const records = new Map<TopicEntry, number>();
    for (const entry of this.#topics.values()) {
      if (!entry.isMasters) records.set(entry, entry.records);
    }
    this.#samples = [...this.#samples, { timeMs, records }].slice(-MAX_SAMPLES);
  }

  /** Records per second over `spanMs` at least, as far as it was measured; undefined without rates of now. */
  rateOf(entry: TopicEntry, spanMs: number): number | undefined {
    const newest = this.#samples.at(-1);
    if (newest === undefined || !this.isReady) return undefined;
    const isBefore = ({ timeMs }: Sample): boolean => timeMs <= newest.timeMs - spanMs;
    const oldest = this.#samples.findLast(isBefore) ?? this.#samples[0]!;
    const records = entry.records - (oldest.records.get(entry) ?? 0);
    return (records * 1_000) / (this.#clock.monotonicMs() - oldest.timeMs);
  }

  #isRecent(sample: Sample | undefined): boolean {
    return sample !== undefined && this.#clock.monotonicMs() - sample.timeMs <= MAX_AGE_MS;
  }
}
