import type { Cancel, Clock } from '@ubii/timing';
import { systemClock } from '@ubii/timing/system';

/** A thread that keeps time: what is posted to it is `[id, delayMs]` or `[id]`, what it posts is an id. */
export interface TimerThread {
  post(message: readonly [id: number, delayMs?: number]): void;
  /** Called once, before the first `post`. */
  onDue(fn: (id: number) => void): void;
}

/** Dependencies of the clock of a page. */
export interface PageTimers {
  readonly isHidden: () => boolean;
  /** Called when a timer is set while the page is hidden, the first time. @throws when there can be none */
  readonly startThread: () => TimerThread;
}

/**
 * The clock of a page that runs modules. Browsers let the timers of a hidden page go off once a second
 * at most, those of a worker on time: while the page is hidden, a worker keeps the time.
 */
export function createPageClock(timers: PageTimers = browserTimers): Clock {
  const waiting = new Map<number, () => void>();
  let thread: TimerThread | 'none' | undefined;
  let ids = 0;

  const threadNow = (): TimerThread | undefined => {
    if (thread === undefined) {
      try {
        thread = timers.startThread();
        thread.onDue((id) => {
          const fn = waiting.get(id);
          waiting.delete(id);
          fn?.();
        });
      } catch {
        thread = 'none'; // late is better than never
      }
    }
    return thread === 'none' ? undefined : thread;
  };

  const after = (delayMs: number, fn: () => void): Cancel => {
    const keeper = timers.isHidden() ? threadNow() : undefined;
    if (keeper === undefined) return systemClock.after(delayMs, fn);
    const id = ++ids;
    waiting.set(id, fn);
    keeper.post([id, delayMs]);
    return () => {
      if (waiting.delete(id)) keeper.post([id]);
    };
  };

  return {
    nowMs: () => systemClock.nowMs(),
    monotonicMs: () => systemClock.monotonicMs(),
    atEndOfTurn: (fn) => systemClock.atEndOfTurn(fn),
    after,
    /** Each step is set again, so that it follows the page when it is hidden and shown. */
    every(intervalMs, fn) {
      let dueMs = systemClock.monotonicMs() + intervalMs;
      let cancel = after(intervalMs, step);
      function step(): void {
        const nowMs = systemClock.monotonicMs();
        dueMs = Math.max(dueMs + intervalMs, nowMs);
        cancel = after(dueMs - nowMs, step);
        fn();
      }
      return () => cancel();
    },
  };
}

const THREAD_SOURCE = `
const timers = new Map();
onmessage = ({ data: [id, delayMs] }) => {
  if (delayMs === undefined) {
    clearTimeout(timers.get(id));
    timers.delete(id);
    return;
  }
  timers.set(id, setTimeout(() => {
    timers.delete(id);
    postMessage(id);
  }, delayMs));
};`;

const browserTimers: PageTimers = {
  isHidden: () => typeof document !== 'undefined' && document.hidden,
  startThread() {
    const url = URL.createObjectURL(new Blob([THREAD_SOURCE], { type: 'text/javascript' }));
    const worker = new Worker(url, { name: 'ubii timers' });
    URL.revokeObjectURL(url);
    return {
      post: (message) => worker.postMessage(message),
      onDue(fn) {
        worker.onmessage = ({ data }: MessageEvent<number>) => fn(data);
      },
    };
  },
};
