import { fuzzyScore } from '../../ui/fuzzy.ts';

/** Entry of the search index. */
export interface SearchEntry {
  readonly title: string;
  /** Searched, too. */
  readonly detail: string;
  /** `Lesson`, `How to`, or the title of the reference page. */
  readonly kind: string;
  readonly to: string;
}

const MAX_RESULTS = 12;
/** Bonus of a match in the title over one in the detail. */
const TITLE_BONUS = 60;

/** Returns the entries that match a query, best first. */
export function searchEntries(query: string, entries: readonly SearchEntry[]): SearchEntry[] {
  const words = query
    .toLowerCase()
    .split(/[^\p{L}\p{N}_-]+/u)
    .filter((word) => word !== '' && !FILLERS.has(word));
  if (words.length === 0) return [];
  const text = words.join(' ');
  return entries
    .flatMap((entry) => {
      const title = fuzzyScore(text, entry.title);
      if (title !== undefined) return [{ entry, score: title + TITLE_BONUS }];
      // Details are long: match whole words only, not letters in order.
      const all = `${entry.title} ${entry.detail}`.toLowerCase();
      if (!words.every((word) => all.includes(word))) return [];
      return [{ entry, score: fuzzyScore(text, all) ?? 0 }];
    })
    .sort((a, b) => b.score - a.score || a.entry.title.length - b.entry.title.length)
    .slice(0, MAX_RESULTS)
    .map(({ entry }) => entry);
}

/** Words of questions that are ignored. */
const FILLERS: ReadonlySet<string> = new Set(
  'a an the how do does can i to what is are my of in on with for it'.split(' '),
);
