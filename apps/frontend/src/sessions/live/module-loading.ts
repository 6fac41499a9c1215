import type { ModuleStatistics } from '@ubii/proto';

/** An asset set that is loaded before a module starts. [PM-94] */
export interface ModuleLoading {
  readonly moduleId: string;
  readonly moduleName: string;
  readonly set: string;
  readonly loadedBytes: number;
  readonly totalBytes: number;
  /** 0 to 1. */
  readonly share: number;
  /** Remaining time, milliseconds; `undefined` until it can be estimated. */
  readonly leftMs: number | undefined;
}

/** Time before the remaining time is estimated, milliseconds. */
const MIN_MS = 500;

/** Returns what a module is loading; `undefined` when nothing. */
export function loadingOf(statistics: ModuleStatistics | undefined): ModuleLoading | undefined {
  if (statistics === undefined || statistics.loadingSet === '') return undefined;
  const { moduleId, moduleName, loadingSet: set, loadedBytes, loadingBytes } = statistics;
  const totalBytes = Math.max(loadedBytes, loadingBytes);
  const share = totalBytes > 0 ? loadedBytes / totalBytes : 0;
  return { moduleId, moduleName, set, loadedBytes, totalBytes, share, leftMs: undefined };
}

/** Estimates the remaining time from the progress so far. */
export class LoadingPace {
  #first: { readonly key: string; readonly bytes: number; readonly atMs: number } | undefined;

  with(loading: ModuleLoading, nowMs: number): ModuleLoading {
    const key = `${loading.moduleId} ${loading.set}`;
    if (this.#first?.key !== key) {
      this.#first = { key, bytes: loading.loadedBytes, atMs: nowMs };
    }
    const passedMs = nowMs - this.#first.atMs;
    const bytes = loading.loadedBytes - this.#first.bytes;
    if (passedMs < MIN_MS || bytes <= 0) return loading;
    const left = loading.totalBytes - loading.loadedBytes;
    return { ...loading, leftMs: (left * passedMs) / bytes };
  }
}
