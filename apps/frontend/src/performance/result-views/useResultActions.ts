import { shallowRef, type ShallowRef } from 'vue';
import { plural } from '@ubii/words';
import { saveFile } from '../../files/save-file.ts';
import type { TextFile } from '../../files/text-file.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { usePerformance } from '../run/usePerformance.ts';
import { resultsFromJson, resultsToCsv, resultsToJson } from '../results/result-file.ts';
import type { TestResult } from '../results/test-result.ts';

const MAX_FILE_NAME = 60;

/** Actions on results. */
export function useResultActions(): {
  exportAs(format: 'json' | 'csv', results: readonly TestResult[]): void;
  remove(results: readonly TestResult[]): void;
  /** Imports files of exported results. @returns ids of the results in them */
  importFiles(files: readonly TextFile[]): Promise<readonly string[]>;
  /** Error of the last import. */
  readonly importFault: Readonly<ShallowRef<string | undefined>>;
} {
  const { results: kept } = usePerformance();
  const toasts = useToasts();
  const importFault = shallowRef<string>();

  return {
    importFault,
    exportAs(format, results) {
      const name =
        results.length === 1 ? results[0]!.name : `Performance, ${results.length} results`;
      const text = format === 'json' ? resultsToJson(results) : resultsToCsv(results);
      saveFile({ name: `${fileName(name)}.${format}`, text });
    },
    remove(results) {
      void kept.remove(results.map(({ id }) => id));
      const what = plural(
        results.length,
        `“${results[0]?.name ?? ''}”`,
        `${results.length} results`,
      );
      toasts.show(`Deleted ${what}`, { text: 'Undo', run: () => void kept.put(...results) });
    },
    async importFiles(files) {
      importFault.value = undefined;
      const ids: string[] = [];
      for (const { name, text } of files) {
        const read = resultsFromJson(text);
        if (read.kind === 'broken') {
          importFault.value = `${name}: ${read.message}`;
          continue;
        }
        // Ids are globally unique: runs that exist already are not replaced.
        await kept.put(...read.value.filter(({ id }) => kept.find(id) === undefined));
        ids.push(...read.value.map(({ id }) => id));
      }
      if (ids.length > 0) {
        toasts.show(plural(ids.length, 'Imported 1 result', `Imported ${ids.length} results`));
      }
      return ids;
    },
  };
}

function fileName(name: string): string {
  const safe = name.replace(/[^\p{L}\p{N}]+/gu, '-').replace(/^-|-$/g, '');
  return safe.slice(0, MAX_FILE_NAME) || 'performance';
}
