import type { ProcessingModule } from '@ubii/proto';
import { plural } from '@ubii/words';
import { isFixed, type ModuleEntry } from '../library/module-entry.ts';

/**
 * Removes built-in modules from an import of several: a file with the whole library contains them, and they exist
 * anyway. A single module is kept, so that the master reports why it is refused.
 */
export function withoutFixed(
  modules: readonly ProcessingModule[],
  entries: readonly ModuleEntry[],
): readonly ProcessingModule[] {
  if (modules.length < 2) return modules;
  const fixed = new Set(entries.filter(isFixed).map(({ module }) => module.name));
  return modules.filter(({ name }) => !fixed.has(name));
}

/** Message about an import; undefined for a single module, which is opened. */
export function importedWords(imported: number, inFile: number): string | undefined {
  if (inFile < 2) return undefined;
  const left = inFile - imported;
  const all = imported === 0 ? 'Nothing to import' : `Imported ${imported} of ${inFile} modules`;
  if (left === 0) return `Imported ${imported} modules`;
  return `${all}: ${plural(left, 'one is a built-in module', `${left} are built-in modules`)}.`;
}
