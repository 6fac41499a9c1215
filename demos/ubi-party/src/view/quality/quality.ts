export type Quality = 'low' | 'middle' | 'high';
const LEVELS: readonly Quality[] = ['low', 'middle', 'high'];

/** Milliseconds of a window's p95: above, a level is too much; below, one more may be tried. */
const TOO_SLOW_MS = 24;
const FAST_MS = 18.5;
/** Windows in a row that must agree. */
const SLOW_WINDOWS = 2;
const FAST_WINDOWS = 4;
/** Each step down doubles the windows that a step up takes; after so many, there is no way up. */
const MAX_FALLS = 3;

/** Frame statistics so far. */
export interface QualityState {
  readonly quality: Quality;
  readonly slowWindows: number;
  readonly fastWindows: number;
  /** Number of steps down in quality. */
  readonly falls: number;
}

export function startQuality(quality: Quality): QualityState {
  return { quality, slowWindows: 0, fastWindows: 0, falls: 0 };
}

/**
 * The level after a window of about two seconds. Goes down after two slow windows and up after four fast ones; between
 * the two limits nothing changes. A device that goes up and down finds its level: each fall makes the next rise later,
 * and after three there is none.
 */
export function nextQuality(state: QualityState, p95Ms: number): QualityState {
  const level = LEVELS.indexOf(state.quality);
  const slowWindows = p95Ms > TOO_SLOW_MS ? state.slowWindows + 1 : 0;
  const fastWindows = p95Ms < FAST_MS ? state.fastWindows + 1 : 0;
  if (slowWindows >= SLOW_WINDOWS && level > 0) {
    return { ...startQuality(LEVELS[level - 1]!), falls: state.falls + 1 };
  }
  const needed = FAST_WINDOWS * 2 ** state.falls;
  if (fastWindows >= needed && level < 2 && state.falls < MAX_FALLS) {
    return { ...startQuality(LEVELS[level + 1]!), falls: state.falls };
  }
  return { ...state, slowWindows, fastWindows };
}

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
