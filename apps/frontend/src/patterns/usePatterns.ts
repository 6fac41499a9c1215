import { lazyPatterns, MeteredPatterns } from '@ubii/patterns';
import { TokenBucket } from '@ubii/timing';
import { shallowRef, type ShallowRef } from 'vue';

/** Time budget for matching the patterns of a view, milliseconds at once and per second on average. */
const MATCH_MS = 250;
const MATCH_MS_PER_SECOND = 100;
/** Most topics cached per pattern: those of a large system. */
const MAX_TEXTS = 65_536;

/** Regular expressions of other clients, for views. */
export interface Patterns {
  /** Undefined while the code is being loaded, which starts with the first read. */
  readonly compiler: MeteredPatterns | undefined;
  /** Rejects when the code cannot be loaded. */
  load(): Promise<MeteredPatterns>;
}

/** Patterns with a time budget of their own, so that none freezes the page. [TD-65] */
export function usePatterns(): Patterns {
  const source = lazyPatterns();
  const compiler: ShallowRef<MeteredPatterns | undefined> = shallowRef();
  const load = async (): Promise<MeteredPatterns> => {
    const loaded = await source.load();
    const monotonicMs = (): number => performance.now();
    const budget = new TokenBucket(MATCH_MS_PER_SECOND, monotonicMs(), MATCH_MS);
    return (compiler.value ??= new MeteredPatterns(loaded, {
      budget,
      monotonicMs,
      maxTexts: MAX_TEXTS,
    }));
  };
  let hasBegun = false;
  return {
    get compiler() {
      if (!hasBegun) {
        hasBegun = true;
        // Retried with the next read.
        load().catch(() => (hasBegun = false));
      }
      return compiler.value;
    },
    load,
  };
}
