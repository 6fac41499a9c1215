import type { ProcessingModule } from '@ubii/proto';
import { Copy, Download, Pencil, Trash2 } from '@lucide/vue';
import type { ShallowRef } from 'vue';
import { useRouter } from 'vue-router';
import { useAttempt } from '../connection/useAttempt.ts';
import { useConnection } from '../connection/useConnection.ts';
import { saveFile } from '../files/save-file.ts';
import type { TextFile } from '../files/text-file.ts';
import { moduleEditorLocation, moduleLocation } from '../locations/module-location.ts';
import { copyName, freeName } from '../sessions/text/session-spec.ts';
import { useToasts } from '../ui/toasts/toasts.ts';
import type { MenuItem } from '../ui/UiMenu.vue';
import { draftNames, dropDraft, keepDraft } from './draft/draft-store.ts';
import type { ModuleDraft } from './draft/module-draft.ts';
import { importedWords, withoutFixed } from './file/import-words.ts';
import { exportModule, exportModules, importModules } from './file/module-file.ts';
import { isDeletable, type ModuleEntry } from './library/module-entry.ts';
import type { ModuleLibrary } from './library/useModuleLibrary.ts';

/** Actions on modules of the library. */
export interface ModuleActions {
  /** Reason why the last action failed; kept until the next one. */
  readonly failure: ShallowRef<string | undefined>;
  menuFor(entry: ModuleEntry): readonly MenuItem[];
  importFiles(files: readonly TextFile[]): Promise<void>;
  /** Exports these modules as one file. */
  exportAll(entries: readonly ModuleEntry[]): void;
  /** Opens the editor for a new module, which is stored on the first save. */
  create(draft: ModuleDraft): Promise<void>;
}

export function useModuleActions(library: ModuleLibrary): ModuleActions {
  const { client } = useConnection();
  const router = useRouter();
  const toasts = useToasts();
  const { problem: failure, attempt } = useAttempt();

  function changed<T>(work: () => Promise<T>): Promise<T | undefined> {
    return attempt(async () => {
      const result = await work();
      await library.refresh();
      return result;
    });
  }

  const save = (module: ProcessingModule): Promise<ProcessingModule> =>
    client.call('processingModuleDatabaseSave', { ...module, id: '', nodeId: '', sessionId: '' });

  async function duplicate({ module }: ModuleEntry): Promise<void> {
    const taken = new Set(library.entries.value?.map((one) => one.module.name));
    const name = copyName(module.name, taken);
    const saved = await changed(() => save({ ...module, name }));
    if (saved) await router.push(moduleLocation(name));
  }

  async function remove({ module }: ModuleEntry): Promise<void> {
    const { name, id } = module;
    const done = await changed(() => client.call('processingModuleDatabaseDelete', { id, name }));
    if (done === undefined) return;
    dropDraft(name);
    await router.push('/modules');
    toasts.show(`Deleted ${name}`, {
      text: 'Undo',
      run: () => void changed(() => save(module)),
    });
  }

  async function importFiles(files: readonly TextFile[]): Promise<void> {
    for (const file of files) {
      const read = importModules(file);
      if (read.kind === 'broken') {
        failure.value = read.message;
        return;
      }
      const modules = withoutFixed(read.modules, library.entries.value ?? []);
      for (const module of modules) {
        const saved = await changed(() => save(module));
        if (saved === undefined) return;
      }
      const [first] = modules;
      const words = importedWords(modules.length, read.modules.length);
      if (words !== undefined) toasts.show(words);
      if (first) await router.push(moduleLocation(first.name));
    }
  }

  async function create(template: ModuleDraft): Promise<void> {
    const taken = new Set([
      ...draftNames(),
      ...(library.entries.value ?? []).map((one) => one.module.name),
    ]);
    const draft = { ...template, name: freeName(template.name, taken) };
    keepDraft(draft.name, { draft, base: undefined });
    await router.push(moduleEditorLocation(draft.name));
  }

  return {
    failure,
    importFiles,
    exportAll: (entries) => saveFile(exportModules(entries.map(({ module }) => module))),
    create,
    menuFor: (entry) => [
      ...(isDeletable(entry)
        ? [
            {
              text: 'Edit or rename',
              icon: Pencil,
              run: () => void router.push(moduleEditorLocation(entry.module.name)),
            },
          ]
        : []),
      {
        text: 'Duplicate',
        icon: Copy,
        disabled: entry.module.onProcessingStringified === '',
        run: () => void duplicate(entry),
      },
      { text: 'Export', icon: Download, run: () => saveFile(exportModule(entry.module)) },
      ...(isDeletable(entry)
        ? ([
            { kind: 'separator' },
            {
              text: 'Delete',
              icon: Trash2,
              shortcut: 'Del',
              danger: true,
              run: () => void remove(entry),
            },
          ] as const)
        : []),
    ],
  };
}
