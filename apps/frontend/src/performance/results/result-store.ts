import { storedValue } from '../../json/read-stored.ts';
import { RESULT } from './result-schema.ts';
import type { TestResult } from './test-result.ts';

const DATABASE = 'ubii.performance';
const STORE = 'results';
const VERSION = 1;

/** Persistent storage of results. */
export interface ResultStore {
  /** Returns all readable results. */
  load(): Promise<TestResult[]>;
  put(result: TestResult): Promise<void>;
  remove(ids: readonly string[]): Promise<void>;
}

/** Opens the storage of this browser for this master's origin. @throws DOMException when storage is not available */
export async function openResultStore(): Promise<ResultStore> {
  const database = await opened();
  const change = (work: (store: IDBObjectStore) => void): Promise<void> =>
    new Promise((resolve, reject) => {
      const transaction = database.transaction(STORE, 'readwrite');
      transaction.oncomplete = () => resolve();
      transaction.onabort = () =>
        reject(transaction.error ?? new Error('The result was not stored.'));
      work(transaction.objectStore(STORE));
    });
  return {
    async load() {
      const all = await answer<unknown[]>(
        database.transaction(STORE, 'readonly').objectStore(STORE).getAll(),
      );
      // Skips results of other versions of this page.
      return all.flatMap((value) => storedValue(RESULT, value) ?? []);
    },
    put: (result) => change((store) => store.put(result)),
    remove: (ids) => change((store) => ids.forEach((id) => store.delete(id))),
  };
}

function opened(): Promise<IDBDatabase> {
  const request = indexedDB.open(DATABASE, VERSION);
  request.onupgradeneeded = () => request.result.createObjectStore(STORE, { keyPath: 'id' });
  return answer(request);
}

function answer<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () =>
      reject(request.error ?? new Error('This browser has no storage for pages.'));
  });
}
