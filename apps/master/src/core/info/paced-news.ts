import { TokenBucket, type Cancel, type Clock } from '@ubii/timing';

/** Announcement budget of a subject, bytes. */
export interface NewsPace {
  readonly bytesPerSecond: number;
  /** Bytes at once. A larger announcement is sent alone, and delays the next one. */
  readonly burstBytes: number;
}

/** Subjects checked with each announcement, to drop idle ones. */
const LOOKED_AT = 2;

interface Subject {
  readonly bucket: TokenBucket;
  /** Publishes the pending announcement when the budget allows; undefined when nothing is pending. */
  tell: (() => number) | undefined;
  cancel: Cancel | undefined;
}

/**
 * Tells states of subjects, of each only so many bytes a second [EX-75]. What cannot be told at once is told as
 * soon as there is room, as it is then: the last state always comes.
 */
export class PacedNews {
  readonly #clock: Clock;
  readonly #pace: NewsPace;
  readonly #subjects = new Map<string, Subject>();

  constructor(clock: Clock, pace: NewsPace) {
    this.#clock = clock;
    this.#pace = pace;
  }

  /** @param tell Publishes the state as it is when it is called; returns the bytes of it, 0 when there was nothing to tell. */
  tell(id: string, tell: () => number): void {
    this.#forgetRested();
    const subject = this.#subjectOf(id);
    if (subject.tell !== undefined) {
      subject.tell = tell;
      return;
    }
    this.#tellOrWait(subject, tell);
  }

  /** Counts an announcement that was sent in another way, without a delay. */
  spend(id: string, bytes: number): void {
    this.#subjectOf(id).bucket.spend(bytes, this.#clock.monotonicMs());
  }

  /** Drops a subject, with its pending announcement. */
  forget(id: string): void {
    this.#subjects.get(id)?.cancel?.();
    this.#subjects.delete(id);
  }

  /** Ends every timer. */
  close(): void {
    for (const id of [...this.#subjects.keys()]) this.forget(id);
  }

  #subjectOf(id: string): Subject {
    let subject = this.#subjects.get(id);
    if (subject === undefined) {
      const { bytesPerSecond, burstBytes } = this.#pace;
      const bucket = new TokenBucket(bytesPerSecond, this.#clock.monotonicMs(), burstBytes);
      subject = { bucket, tell: undefined, cancel: undefined };
      this.#subjects.set(id, subject);
    }
    return subject;
  }

  /** A subject with a full budget equals an unknown one. */
  #forgetRested(): void {
    const nowMs = this.#clock.monotonicMs();
    let looked = 0;
    for (const [id, subject] of this.#subjects) {
      if (++looked > LOOKED_AT) return;
      this.#subjects.delete(id);
      const isRested =
        subject.tell === undefined && subject.bucket.has(this.#pace.burstBytes, nowMs);
      // To the end: the others have their turn next.
      if (!isRested) this.#subjects.set(id, subject);
    }
  }

  #tellOrWait(subject: Subject, tell: () => number): void {
    const nowMs = this.#clock.monotonicMs();
    const waitMs = subject.bucket.waitMs(nowMs);
    if (waitMs === 0) {
      subject.bucket.spend(tell(), nowMs);
      return;
    }
    subject.tell = tell;
    subject.cancel = this.#clock.after(waitMs, () => {
      const waiting = subject.tell;
      subject.tell = undefined;
      subject.cancel = undefined;
      if (waiting !== undefined) this.#tellOrWait(subject, waiting);
    });
  }
}
