import { describe, expect, it } from 'vitest';
import { createKeptResults, MAX_RESULTS } from './kept-results.ts';
import type { ResultStore } from './result-store.ts';
import type { TestResult } from './test-result.ts';
import { aResult } from './testing/a-result.ts';

function memoryStore(...first: TestResult[]) {
  const kept = new Map(first.map((result) => [result.id, result]));
  const store: ResultStore = {
    load: async () => [...kept.values()],
    put: async (result) => void kept.set(result.id, result),
    remove: async (ids) => ids.forEach((id) => kept.delete(id)),
  };
  return { kept, store };
}

describe('kept results', () => {
  it('are those of before, newest first', async () => {
    const { store } = memoryStore(
      aResult({ id: 'old', startedMs: 1 }),
      aResult({ id: 'new', startedMs: 2 }),
    );
    const results = createKeptResults(async () => store);
    expect(results.list.value).toBeUndefined();
    await results.ready;
    expect(results.list.value?.map(({ id }) => id)).toEqual(['new', 'old']);
  });

  it('can be renamed and removed', async () => {
    const { kept, store } = memoryStore(aResult());
    const results = createKeptResults(async () => store);
    await results.ready;
    await results.rename('one', 'At home');
    expect(kept.get('one')?.name).toBe('At home');
    await results.remove(['one']);
    expect(kept.size).toBe(0);
    expect(results.list.value).toEqual([]);
  });

  it('are bounded: the oldest goes', async () => {
    const full = Array.from({ length: MAX_RESULTS }, (_, index) =>
      aResult({ id: `${index}`, startedMs: index }),
    );
    const { kept, store } = memoryStore(...full);
    const results = createKeptResults(async () => store);
    await results.ready;
    await results.put(aResult({ id: 'newest', startedMs: 1e6 }));
    expect(results.list.value).toHaveLength(MAX_RESULTS);
    expect(results.list.value?.[0]?.id).toBe('newest');
    expect(kept.has('0')).toBe(false);
    expect(kept.has('1')).toBe(true);
  });

  it('stay with the page where the browser keeps nothing, which is said', async () => {
    const results = createKeptResults(async () => {
      throw new Error('private window');
    });
    await results.ready;
    await results.put(aResult());
    expect(results.list.value).toHaveLength(1);
    expect(results.trouble.value).toContain('private window');
  });

  it('keep what was measured while they were loaded', async () => {
    const { store } = memoryStore(aResult({ id: 'old', startedMs: 1 }));
    const results = createKeptResults(async () => store);
    await results.put(aResult({ id: 'new', startedMs: 2 }));
    await results.ready;
    expect(results.list.value?.map(({ id }) => id)).toEqual(['new', 'old']);
  });
});
