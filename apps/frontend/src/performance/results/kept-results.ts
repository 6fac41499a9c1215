import { shallowRef, type ShallowRef } from 'vue';
import type { ResultStore } from './result-store.ts';
import type { TestResult } from './test-result.ts';

/** Most stored results, some tens of KiB each; the oldest is evicted. */
export const MAX_RESULTS = 100;

/** Results stored in this browser. */
export interface KeptResults {
  /** Newest first; `undefined` until they are loaded. */
  readonly list: Readonly<ShallowRef<readonly TestResult[] | undefined>>;
  /** Reason why results cannot be stored; they are kept until the page is left. */
  readonly trouble: Readonly<ShallowRef<string | undefined>>;
  find(id: string): TestResult | undefined;
  /** Adds results, or replaces those with the same id. */
  put(...results: readonly TestResult[]): Promise<void>;
  rename(id: string, name: string): Promise<void>;
  remove(ids: readonly string[]): Promise<void>;
  /** Resolves when the stored results are loaded. */
  readonly ready: Promise<void>;
}

const newestFirst = (a: TestResult, b: TestResult): number => b.startedMs - a.startedMs;

/** @param open opens the storage; when it fails, results are kept in memory only */
export function createKeptResults(open: () => Promise<ResultStore>): KeptResults {
  const list = shallowRef<readonly TestResult[]>();
  const trouble = shallowRef<string>();
  const find = (id: string): TestResult | undefined =>
    list.value?.find((result) => result.id === id);

  function complain(cause: unknown): void {
    const reason = cause instanceof Error ? cause.message : String(cause);
    trouble.value = `This browser cannot store results (${reason}). Export the results you need.`;
  }
  const store = open();
  const ready = store
    .then((opened) => opened.load())
    .catch((cause: unknown): TestResult[] => (complain(cause), []))
    .then((kept) => {
      const newer = list.value ?? [];
      const ids = new Set(newer.map(({ id }) => id));
      list.value = [...newer, ...kept.filter(({ id }) => !ids.has(id))].sort(newestFirst);
    });

  async function keep(work: (opened: ResultStore) => Promise<void>): Promise<void> {
    try {
      await work(await store);
    } catch (cause) {
      complain(cause);
    }
  }

  async function put(...results: readonly TestResult[]): Promise<void> {
    if (results.length === 0) return;
    const ids = new Set(results.map(({ id }) => id));
    const all = [...results, ...(list.value ?? []).filter(({ id }) => !ids.has(id))].sort(
      newestFirst,
    );
    list.value = all.slice(0, MAX_RESULTS);
    const gone = all.slice(MAX_RESULTS).map(({ id }) => id);
    await keep(async (opened) => {
      for (const result of results) if (!gone.includes(result.id)) await opened.put(result);
      if (gone.length > 0) await opened.remove(gone);
    });
  }

  return {
    list,
    trouble,
    find,
    ready,
    put,
    async rename(id, name) {
      const result = find(id);
      if (result !== undefined) await put({ ...result, name });
    },
    async remove(ids) {
      list.value = list.value?.filter(({ id }) => !ids.includes(id));
      await keep((opened) => opened.remove(ids));
    },
  };
}
