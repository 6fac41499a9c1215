import { FileNews } from '../library/file-news.ts';
import { ModuleHistory } from '../library/module-history.ts';
import { ModuleLibrary } from '../library/module-library.ts';
import { StoredMessages } from '../library/stored-messages.ts';
import { watchModuleFiles } from '../library/stored-module-versions.ts';
import { SessionLibrary } from '../sessions/session-library.ts';
import type { Foundation } from './foundation.ts';
import type { MasterPorts } from './settings.ts';

/** Stored modules with their versions, and stored sessions. */
export type LibraryArea = ReturnType<typeof createLibrary>;

export type LibraryAreaContext = Pick<
  MasterPorts,
  'clock' | 'ids' | 'log' | 'storage' | 'library' | 'cluster'
> &
  Pick<Foundation, 'id' | 'events' | 'onClose'>;

export function createLibrary(context: LibraryAreaContext) {
  const { id, clock, ids, log, events, storage } = context;
  const stored = new StoredMessages(storage.sessions, 'ubii.sessions.Session');
  const running = new StoredMessages(storage.running, 'ubii.sessions.Session');
  const storedModules = new StoredMessages(storage.modules, 'ubii.processing.ProcessingModule');
  const files = new FileNews({ log, events }, [stored, storedModules, running]);
  const history = new ModuleHistory({ store: storage.history, clock, log });
  const unwatchModules = watchModuleFiles(history, storedModules);
  const sessionLibrary = new SessionLibrary({
    stored,
    running,
    masterId: id,
    log,
    ids,
    remembersAll: context.cluster !== undefined,
  });

  context.onClose.add(() => {
    files.close();
    unwatchModules();
    sessionLibrary.close();
    for (const store of [storage.sessions, storage.modules, storage.running, storage.history])
      store.close();
  });
  return {
    modules: new ModuleLibrary(context.library, storedModules),
    history,
    sessionLibrary,
    files,
  };
}
