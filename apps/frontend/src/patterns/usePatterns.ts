import { lazyPatterns, MeteredPatterns } from '@ubii/patterns';
import { TokenBucket } from '@ubii/timing';
import { shallowRef, type ShallowRef } from 'vue';

/** What matching the patterns of a view may take at once, milliseconds, and a second in the long run. */
const MATCH_MS = 250;
const MATCH_MS_PER_SECOND = 100;
/** Topics whose answers are remembered for each pattern: those of a large system. */
const MAX_TEXTS = 65_536;

/** Regular expressions that others wrote, for views. */
export interface Patterns {
  /** Undefined while the code is loaded, which begins when this is read first. */
  readonly compiler: MeteredPatterns | undefined;
  /** Rejects when the code cannot be had. */
  load(): Promise<MeteredPatterns>;
}

/** Patterns with a budget of time of their own, so that none freezes the page. [TD-65] */
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
        // Tried again with the next look
        load().catch(() => (hasBegun = false));
      }
      return compiler.value;
    },
    load,
  };
}
