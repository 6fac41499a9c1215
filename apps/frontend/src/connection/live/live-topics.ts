import { perFrame } from '../per-frame.ts';
import { joinStatus, nextStatus, type LiveEvent, type LiveStatus } from './live-status.ts';
import { RecordWindow, type RecordView, type WindowRecord } from './record-window.ts';
import { patternKey, patternRateHz, type LivePattern } from './topic-source.ts';

/** Subscription of the client. */
export interface LiveSubscription {
  /** Rejects when the master refuses it, or when it ends before. */
  readonly ready: Promise<void>;
  /** Unsubscribes. */
  close(): void;
}

/** Dependencies and callbacks of live topics. */
export interface LiveTopicsPorts<R> {
  subscribe(pattern: LivePattern, onRecord: (record: R) => void): LiveSubscription;
  /** Calls `fn` once, before the next frame. */
  atFrame(fn: () => void): void;
  /** Called with each new record, but not with repeated ones. */
  onRecord(record: R): void;
  /** Called at most once per frame, and at once when records are dropped. */
  show(view: RecordView<R>): void;
  showStatus(status: LiveStatus): void;
}

interface Followed {
  readonly rateHz: number | undefined;
  readonly subscription: LiveSubscription;
  status: LiveStatus;
}

/**
 * Topics of a part of a page: subscribed while it is visible, with the last records of each. A fast topic causes one
 * update per frame.
 */
export class LiveTopics<R extends WindowRecord> {
  readonly #ports: LiveTopicsPorts<R>;
  readonly #keep: number;
  readonly #window: RecordWindow<R>;
  #patterns = new Map<string, LivePattern>();
  readonly #followed = new Map<string, Followed>();
  readonly #draw: () => void;
  #isSeen = true;

  /** @param keep number of records per topic; 0: none are kept or shown */
  constructor(keep: number, ports: LiveTopicsPorts<R>) {
    this.#keep = keep;
    this.#ports = ports;
    this.#window = new RecordWindow(keep);
    this.#draw = perFrame(() => {
      if (this.#patterns.size > 0) ports.show(this.#window.take());
    }, ports.atFrame);
  }

  /** Sets the patterns. Drops the records of removed ones. */
  follow(patterns: readonly LivePattern[]): void {
    const next = new Map(patterns.map((pattern) => [patternKey(pattern), pattern]));
    const left = [...this.#patterns.keys()].filter((key) => !next.has(key));
    this.#patterns = next;
    this.#update();
    for (const key of left) this.#window.forget(key);
    if (left.length > 0) this.#ports.show(this.#window.take());
  }

  /** While hidden, there are no subscriptions; received records stay. */
  setSeen(isSeen: boolean): void {
    this.#isSeen = isSeen;
    this.#update();
  }

  /** After reconnecting, the newest record of a topic may be received again. */
  expectRepeats(): void {
    this.#window.expectRepeats();
  }

  close(): void {
    this.#patterns.clear();
    this.#update();
  }

  #update(): void {
    const wanted: ReadonlyMap<string, LivePattern> = this.#isSeen ? this.#patterns : new Map();
    for (const [key, followed] of this.#followed) {
      if (!wanted.has(key)) this.#end(key, followed);
    }
    for (const [key, pattern] of wanted) {
      const before = this.#followed.get(key);
      if (before !== undefined && before.rateHz === patternRateHz(pattern)) continue;
      // Subscribe before unsubscribing: the client drops the newest record with the last subscription of a topic.
      this.#begin(key, pattern);
      before?.subscription.close();
    }
    this.#tellStatus();
  }

  #begin(key: string, pattern: LivePattern): void {
    this.#window.expectRepeats(key);
    const subscription = this.#ports.subscribe(pattern, (record) => this.#handle(record, key));
    const status = nextStatus('off', 'subscribe');
    const followed: Followed = { rateHz: patternRateHz(pattern), subscription, status };
    this.#followed.set(key, followed);
    subscription.ready.then(
      () => this.#move(followed, 'accept'),
      () => this.#move(followed, 'refuse'),
    );
  }

  #end(key: string, followed: Followed): void {
    this.#followed.delete(key);
    followed.status = nextStatus(followed.status, 'unsubscribe');
    followed.subscription.close();
  }

  #move(followed: Followed, event: LiveEvent): void {
    followed.status = nextStatus(followed.status, event);
    this.#tellStatus();
  }

  #tellStatus(): void {
    this.#ports.showStatus(joinStatus([...this.#followed.values()].map(({ status }) => status)));
  }

  #handle(record: R, key: string): void {
    if (this.#keep > 0 && !this.#window.add(record, key)) return;
    this.#ports.onRecord(record);
    if (this.#keep > 0) this.#draw();
  }
}
