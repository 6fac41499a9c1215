import { onScopeDispose } from 'vue';

/** Epoch milliseconds of this computer's clock, with fractions; monotonic. */
export const nowMs = (): number => performance.timeOrigin + performance.now();

/** Interval between readings, milliseconds: as fast as digits can be read. */
export const READING_MS = 125;

/** One frame of a page, the same for all its views. */
export interface PageFrame {
  /** Time of the frame, this computer's clock. */
  readonly nowMs: number;
  /** Time of the last reading: numbers on the page are those of this instant. */
  readonly readMs: number;
  /** True in the frame in which the views renew their numbers. */
  readonly isReading: boolean;
}

/** Dependencies of a page clock. */
export interface PageClockPorts {
  nowMs(): number;
  /** Calls back in the next frame, while the page is visible. @returns a function that cancels */
  atFrame(run: () => void): () => void;
}

/** Gives all views of a page the same time: lines end together, and one topic has one current value. */
export class PageClock {
  readonly #ports: PageClockPorts;
  readonly #views = new Set<(frame: PageFrame) => void>();
  #cancel: (() => void) | undefined;
  #readMs = 0;

  constructor(ports: PageClockPorts) {
    this.#ports = ports;
  }

  /** @returns a function that ends the calls */
  follow(view: (frame: PageFrame) => void): () => void {
    this.#views.add(view);
    this.#cancel ??= this.#ports.atFrame(() => this.#tick());
    return () => {
      this.#views.delete(view);
      if (this.#views.size > 0) return;
      this.#cancel?.();
      this.#cancel = undefined;
    };
  }

  #tick(): void {
    this.#cancel = this.#ports.atFrame(() => this.#tick());
    const now = this.#ports.nowMs();
    const isReading = Math.floor(now / READING_MS) !== Math.floor(this.#readMs / READING_MS);
    if (isReading) this.#readMs = now;
    const frame: PageFrame = { nowMs: now, readMs: this.#readMs, isReading };
    for (const view of this.#views) view(frame);
  }
}

const pageClock = new PageClock({
  nowMs,
  atFrame(run) {
    const request = requestAnimationFrame(run);
    return () => cancelAnimationFrame(request);
  },
});

/** Calls `view` in each frame of the page, while the calling scope is active and the page is visible. */
export function usePageFrames(view: (frame: PageFrame) => void): void {
  onScopeDispose(pageClock.follow(view));
}

/** Calls `read` when the numbers on the page are renewed. */
export function usePageReadings(read: (readMs: number) => void): void {
  usePageFrames(({ isReading, readMs }) => isReading && read(readMs));
}
