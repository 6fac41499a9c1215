import type { ProcessingModule } from '@ubii/proto';
import { plural } from '@ubii/words';
import { isFixed, type ModuleEntry } from '../library/module-entry.ts';

/**
 * What can be stored of a file of several: a file with the whole library also holds what came with the
 * program, which is there anyway. One that is imported alone was meant: the master says why not.
 */
export function withoutFixed(
  modules: readonly ProcessingModule[],
  entries: readonly ModuleEntry[],
): readonly ProcessingModule[] {
  if (modules.length < 2) return modules;
  const fixed = new Set(entries.filter(isFixed).map(({ module }) => module.name));
  return modules.filter(({ name }) => !fixed.has(name));
}

/** What is said of an import; nothing of one module, which is opened. */
export function importedWords(imported: number, inFile: number): string | undefined {
  if (inFile < 2) return undefined;
  const left = inFile - imported;
  const all = imported === 0 ? 'Nothing to import' : `Imported ${imported} of ${inFile} modules`;
  if (left === 0) return `Imported ${imported} modules`;
  return `${all}: ${plural(left, 'one is a built-in module', `${left} are built-in modules`)}.`;
}
