import { join } from 'node:path';

import type { SessionStorage } from '../../core/ports/index.ts';
import { FileDocuments } from './file-documents.ts';

/** What a master keeps in its data directory [SE-20]. */
export function openStorage(dataDir: string): SessionStorage & { settled(): Promise<void> } {
  const sessions = new FileDocuments(join(dataDir, 'sessions'), '.session');
  const modules = new FileDocuments(join(dataDir, 'modules'), '.pm');
  const running = new FileDocuments(join(dataDir, 'running'), '.session');
  const history = new FileDocuments(join(dataDir, 'history'), '.json');
  return {
    sessions,
    modules,
    running,
    history,
    async settled() {
      await Promise.all([sessions, modules, running, history].map((store) => store.settled()));
    },
  };
}
