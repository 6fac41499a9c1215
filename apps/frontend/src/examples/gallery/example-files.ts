import { sessionText } from '../../sessions/text/session-text.ts';
import type { SourceFile } from '../source-file.ts';
import type { GalleryEntry } from './gallery.ts';
import type { PreviewKit } from './preview/preview-kit.ts';

const SOURCES = import.meta.glob<string>(
  ['../../../../../packages/modules/src/*/*.ts', '!**/*.test.ts', '!**/{examples,generated}/*.ts'],
  { query: '?raw', import: 'default' },
);

/** Returns the source file of a module. One file has all variants of a module, such as `low-pass-vector2`. */
function sourceOf(module: string): SourceFile | undefined {
  const found = Object.entries(SOURCES)
    .filter(([path]) => module.startsWith(path.split('/').at(-2) ?? ''))
    .sort(([a], [b]) => b.length - a.length)[0];
  return found && { name: module, fileName: found[0].split('/').at(-1)!, load: found[1] };
}

/** Returns the files of an example: its session as JSON, and the source of each of its modules. */
export function exampleFiles(
  entry: GalleryEntry,
  modules: readonly string[],
  loadKit: () => Promise<PreviewKit>,
): SourceFile[] {
  return [
    {
      name: 'Session',
      fileName: `${entry.id}.json`,
      load: async () => sessionText((await loadKit()).spec(entry)),
    },
    ...[...new Set(modules)].flatMap((name) => sourceOf(name) ?? []),
  ];
}
