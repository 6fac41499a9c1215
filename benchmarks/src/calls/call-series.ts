import { percentile } from '../statistics.ts';

/** Room for the samples of the fastest calls and the longest run. */
const MAX_SAMPLES = 1_000_000;
/** No answer for so long: it is lost. */
const STALL_MS = 2_000;

/** One thing that can be called, again and again. */
export interface Callee<Prepared, Answer> {
  /** Number of the last call; continues from one measurement to the next. */
  sequence: number;
  /** Makes what call number `sequence` needs; not measured. */
  prepare(sequence: number): Prepared;
  call(prepared: Prepared): Promise<Answer>;
  isRight(answer: Answer, sequence: number): boolean;
  /** Lets the call under way reject, where it may be lost. */
  abandon?(reason: Error): void;
  /** Other faults since the last call of this function, one sentence each. */
  takeFaults?(): string[];
}

/** Calls one after the other: each waits for the answer of the one before. In Node and in browsers. */
export class CallSeries<Prepared, Answer> {
  /** Calls that count. */
  count = 0;
  readonly #callee: Callee<Prepared, Answer>;
  readonly #first: number;
  readonly #tookUs = new Float64Array(MAX_SAMPLES);
  readonly #heldUs = new Float64Array(MAX_SAMPLES);
  readonly #faults: string[] = [];
  #wrong = 0;

  constructor(callee: Callee<Prepared, Answer>) {
    this.#callee = callee;
    this.#first = callee.sequence;
  }

  /** Calls for some time; those that were made before count no more. After a failed call none is made. */
  async run(durationMs: number): Promise<void> {
    this.count = 0;
    if (this.#faults.length > 0) return;
    const callee = this.#callee;
    const stopWatching = watch(
      () => callee.sequence,
      () => callee.abandon?.(new Error(`there was no answer within ${STALL_MS / 1000} s`)),
    );
    try {
      const untilMs = performance.now() + durationMs;
      while (performance.now() < untilMs) await this.#callOnce();
    } catch (error) {
      this.#faults.push(`call ${callee.sequence} failed: ${messageOf(error)}`);
    }
    stopWatching();
  }

  /** Microseconds. `held`: how long the thread was busy with a call before it could do anything else. */
  result() {
    const took = this.#tookUs.subarray(0, this.count).sort();
    const held = this.#heldUs.subarray(0, this.count).sort();
    const made = this.#callee.sequence - this.#first;
    return {
      p50Us: percentile(took, 0.5),
      p99Us: percentile(took, 0.99),
      heldP50Us: percentile(held, 0.5),
      heldP99Us: percentile(held, 0.99),
      count: this.count,
      faults: [
        ...this.#faults,
        ...(this.#wrong > 0 ? [`${this.#wrong} of ${made} answers were wrong`] : []),
        ...(this.#callee.takeFaults?.() ?? []),
      ],
    };
  }

  async #callOnce(): Promise<void> {
    const callee = this.#callee;
    callee.sequence += 1;
    const { sequence } = callee;
    const prepared = callee.prepare(sequence);
    const startMs = performance.now();
    const answered = callee.call(prepared);
    let heldMs = 0;
    // Microtasks that a call leaves for the end of the turn block the thread as well.
    queueMicrotask(() => (heldMs = performance.now() - startMs));
    const answer = await answered;
    const tookMs = performance.now() - startMs;
    if (!callee.isRight(answer, sequence)) this.#wrong += 1;
    if (this.count === MAX_SAMPLES) return;
    this.#tookUs[this.count] = tookMs * 1000;
    this.#heldUs[this.count] = heldMs * 1000;
    this.count += 1;
  }
}

/** Calls `onStall` when `progress` says the same for too long. */
function watch(progress: () => number, onStall: () => void): () => void {
  let before = progress();
  const timer = setInterval(() => {
    const now = progress();
    if (now === before) onStall();
    before = now;
  }, STALL_MS);
  return () => clearInterval(timer);
}

/** Faults of modules are values, not errors. */
function messageOf(thrown: unknown): string {
  const isObject = typeof thrown === 'object' && thrown !== null;
  return isObject && 'message' in thrown ? String(thrown.message) : String(thrown);
}
