import { nextQuality, startQuality, type Quality, type QualityState } from './quality.ts';

const WINDOW_MS = 2000;
/** A pause (a hidden tab, a breakpoint) says nothing about the device. */
const PAUSE_MS = 5000;

/** Measures the time between frames and chooses the level of quality. */
export class FrameMeter {
  readonly #gapsMs: number[] = [];
  #quality: QualityState;
  #windowMs = 0;
  #p95Ms = 0;

  constructor(quality: Quality) {
    this.#quality = startQuality(quality);
  }

  get p95Ms(): number {
    return this.#p95Ms;
  }

  get quality(): Quality {
    return this.#quality.quality;
  }

  /** A frame came so long after the one before. */
  take(gapMs: number): void {
    if (gapMs <= 0 || gapMs > PAUSE_MS) return;
    this.#gapsMs.push(gapMs);
    this.#windowMs += gapMs;
    if (this.#windowMs < WINDOW_MS) return;
    this.#gapsMs.sort((a, b) => a - b);
    this.#p95Ms = this.#gapsMs[Math.floor(this.#gapsMs.length * 0.95)]!;
    this.#quality = nextQuality(this.#quality, this.#p95Ms);
    this.#gapsMs.length = 0;
    this.#windowMs = 0;
  }

  /** The next gap belongs to a new scene: what it took to build says nothing about the level. */
  restart(): void {
    this.#gapsMs.length = 0;
    this.#windowMs = 0;
  }
}
