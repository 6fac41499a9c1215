import { perFrame } from '../per-frame.ts';
import { joinStatus, nextStatus, type LiveEvent, type LiveStatus } from './live-status.ts';
import { RecordWindow, type RecordView, type WindowRecord } from './record-window.ts';
import { patternKey, patternRateHz, type LivePattern } from './topic-source.ts';

/** A subscription at the client. */
export interface LiveSubscription {
  /** Rejects when the master refuses it, or when it ends before. */
  readonly ready: Promise<void>;
  /** Ends it: no record comes any more. */
  close(): void;
}

/** What live topics need, and whom they tell. */
export interface LiveTopicsPorts<R> {
  subscribe(pattern: LivePattern, onRecord: (record: R) => void): LiveSubscription;
  /** Calls `fn` once, before the next frame is drawn. */
  atFrame(fn: () => void): void;
  /** Called with each record as it comes, but not with one that was there before. */
  onRecord(record: R): void;
  /** Called at most once a frame, and at once when records are forgotten. */
  show(view: RecordView<R>): void;
  showStatus(status: LiveStatus): void;
}

interface Followed {
  readonly rateHz: number | undefined;
  readonly subscription: LiveSubscription;
  status: LiveStatus;
}

/**
 * The topics that one part of a page shows: subscribed to while they are seen, with the last records of each. A fast
 * topic costs one update a frame.
 */
export class LiveTopics<R extends WindowRecord> {
  readonly #ports: LiveTopicsPorts<R>;
  readonly #keep: number;
  readonly #window: RecordWindow<R>;
  #patterns = new Map<string, LivePattern>();
  readonly #followed = new Map<string, Followed>();
  readonly #draw: () => void;
  #isSeen = true;

  /** @param keep records kept of each topic; 0 to keep none and draw nothing */
  constructor(keep: number, ports: LiveTopicsPorts<R>) {
    this.#keep = keep;
    this.#ports = ports;
    this.#window = new RecordWindow(keep);
    this.#draw = perFrame(() => {
      if (this.#patterns.size > 0) ports.show(this.#window.take());
    }, ports.atFrame);
  }

  /** Makes these the patterns. The records of those that are left out are forgotten. */
  follow(patterns: readonly LivePattern[]): void {
    const next = new Map(patterns.map((pattern) => [patternKey(pattern), pattern]));
    const left = [...this.#patterns.keys()].filter((key) => !next.has(key));
    this.#patterns = next;
    this.#update();
    for (const key of left) this.#window.forget(key);
    if (left.length > 0) this.#ports.show(this.#window.take());
  }

  /** While they are not seen, there are no subscriptions; what came before stays. */
  setSeen(isSeen: boolean): void {
    this.#isSeen = isSeen;
    this.#update();
  }

  /** The link is back: the newest record of a topic may come a second time. */
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
      // The new one first: with the last subscription of a topic the client forgets its newest record.
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
