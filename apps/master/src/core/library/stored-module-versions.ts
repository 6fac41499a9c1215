import { ModuleVersionOrigin, type ProcessingModule } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import type { ModuleHistory } from './module-history.ts';
import type { StoredMessages } from './stored-messages.ts';

type StoredModules = StoredMessages<'ubii.processing.ProcessingModule'>;

/** Adds a version to stored modules whose file has changed, also while no master ran [EX-41]. */
export function watchModuleFiles(history: ModuleHistory, stored: StoredModules): Cancel {
  let known = modulesByName(stored);
  for (const [name, module] of known) {
    if (history.list(`module ${name}`) === undefined) continue;
    if (history.isNewest(`module ${name}`, module)) continue;
    void history.record(`module ${name}`, undefined, module, ModuleVersionOrigin.FILE);
  }
  return stored.store.onChange(() => {
    const before = known;
    known = modulesByName(stored);
    for (const [name, module] of known) {
      if (before.get(name) === module) continue;
      if (history.isNewest(`module ${name}`, module)) continue;
      void history.record(`module ${name}`, before.get(name), module, ModuleVersionOrigin.FILE);
    }
  });
}

function modulesByName(stored: StoredModules): ReadonlyMap<string, ProcessingModule> {
  return new Map([...stored.list()].map(([name, { message }]) => [name, message]));
}
