import type { Cancel, Clock } from '@ubii/timing';

import type { KvBucket } from './kv-bucket.ts';

/** Every master has heard of a removal by then, milliseconds. */
const KEPT_MS = 10 * 60_000;
/** How often it is checked, milliseconds. */
const CHECK_MS = 60_000;
/** At most this many keys are forgotten at once. */
const MAX_AT_ONCE = 100;

interface Removal {
  readonly rawKey: string;
  readonly revision: number;
  readonly timeMs: number;
}

/**
 * What is left of deleted keys in a bucket. It tells masters that were away of the removal, and is removed itself
 * later, or a bucket of sessions that come and go would grow forever. NATS does so by itself from version 2.11.
 */
export class Removals {
  readonly #bucket: Pick<KvBucket, 'forget'>;
  readonly #clock: Clock;
  readonly #handleForgotten: (rawKey: string, revision: number) => void;
  readonly #cancel: Cancel;
  #waiting: Removal[] = [];

  /** @param handleForgotten called when nothing is left of a deletion */
  constructor(
    bucket: Pick<KvBucket, 'forget'>,
    clock: Clock,
    handleForgotten: (rawKey: string, revision: number) => void,
  ) {
    this.#bucket = bucket;
    this.#clock = clock;
    this.#handleForgotten = handleForgotten;
    this.#cancel = clock.every(CHECK_MS, () => this.#forgetOld());
  }

  add(rawKey: string, revision: number, timeMs: number): void {
    this.#waiting.push({ rawKey, revision, timeMs });
  }

  close(): void {
    this.#cancel();
  }

  #forgetOld(): void {
    const until = this.#clock.nowMs() - KEPT_MS;
    const old = this.#waiting.filter(({ timeMs }) => timeMs < until).slice(0, MAX_AT_ONCE);
    if (old.length === 0) return;
    const isOld = new Set(old);
    this.#waiting = this.#waiting.filter((each) => !isOld.has(each));
    for (const removal of old) {
      const { rawKey, revision } = removal;
      this.#bucket.forget(rawKey, revision).then(
        () => this.#handleForgotten(rawKey, revision),
        () => this.#waiting.push(removal), // While NATS is away: later.
      );
    }
  }
}
