/** Battery level, and whether it is charging. */
export interface BatteryState {
  /** 0 to 1. */
  readonly level: number;
  readonly isCharging: boolean;
}

/** Chromium only; other browsers omit it to prevent fingerprinting. */
interface BatteryManager extends EventTarget {
  readonly level: number;
  readonly charging: boolean;
}

/**
 * Reports the battery state now and whenever it changes; never, where the browser does not provide it.
 * @returns a function that stops it
 */
export function watchBattery(handle: (state: BatteryState) => void): () => void {
  const { getBattery } = navigator as { getBattery?: () => Promise<BatteryManager> };
  const ended = new AbortController();
  void getBattery?.call(navigator).then(
    (source) => {
      if (ended.signal.aborted) return;
      const read = (): void => handle({ level: source.level, isCharging: source.charging });
      read();
      for (const type of ['levelchange', 'chargingchange']) {
        source.addEventListener(type, read, { signal: ended.signal });
      }
    },
    () => undefined,
  );
  return () => ended.abort();
}
