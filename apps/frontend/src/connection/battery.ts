/** How full the battery is, and whether it fills. */
export interface BatteryState {
  /** 0 to 1. */
  readonly level: number;
  readonly isCharging: boolean;
}

/** Chromium's battery; others tell nothing, to keep people from being recognised by it. */
interface BatteryManager extends EventTarget {
  readonly level: number;
  readonly charging: boolean;
}

/**
 * Tells of the battery now and whenever it changes; says nothing where the browser gives none.
 * @returns ends it
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
