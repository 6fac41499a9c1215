import { TokenBucket, type Cancel, type Clock } from '@ubii/timing';

/** Announcement budget of a subject, bytes. */
export interface AnnouncementRate {
  readonly bytesPerSecond: number;
  /** Bytes at once. A larger announcement is sent alone, and delays the next one. */
  readonly burstBytes: number;
}

/** Subjects checked with each announcement, to drop idle ones. */
const LOOKED_AT = 2;

interface Subject {
  readonly bucket: TokenBucket;
  /** Publishes the pending announcement when the budget allows; undefined when nothing is pending. */
  publish: (() => number) | undefined;
  cancel: Cancel | undefined;
}

/**
 * Announces states of subjects within a byte rate for each [EX-75]. A delayed announcement has the state of the time at
 * which it is sent, and the last state is always sent.
 */
export class PacedAnnouncements {
  readonly #clock: Clock;
  readonly #rate: AnnouncementRate;
  readonly #subjects = new Map<string, Subject>();

  constructor(clock: Clock, rate: AnnouncementRate) {
    this.#clock = clock;
    this.#rate = rate;
  }

  /** @param publish Publishes the state as it is when it is called; returns the bytes of it, 0 when there was nothing to publish. */
  announce(id: string, publish: () => number): void {
    this.#forgetRested();
    const subject = this.#subjectOf(id);
    if (subject.publish !== undefined) {
      subject.publish = publish;
      return;
    }
    this.#publishOrWait(subject, publish);
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
      const { bytesPerSecond, burstBytes } = this.#rate;
      const bucket = new TokenBucket(bytesPerSecond, this.#clock.monotonicMs(), burstBytes);
      subject = { bucket, publish: undefined, cancel: undefined };
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
        subject.publish === undefined && subject.bucket.has(this.#rate.burstBytes, nowMs);
      // To the end: the others have their turn next.
      if (!isRested) this.#subjects.set(id, subject);
    }
  }

  #publishOrWait(subject: Subject, publish: () => number): void {
    const nowMs = this.#clock.monotonicMs();
    const waitMs = subject.bucket.waitMs(nowMs);
    if (waitMs === 0) {
      subject.bucket.spend(publish(), nowMs);
      return;
    }
    subject.publish = publish;
    subject.cancel = this.#clock.after(waitMs, () => {
      const waiting = subject.publish;
      subject.publish = undefined;
      subject.cancel = undefined;
      if (waiting !== undefined) this.#publishOrWait(subject, waiting);
    });
  }
}
