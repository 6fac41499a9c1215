import { join } from 'node:path';

import type { DocumentStore, SessionStorage } from '../../core/ports/index.ts';
import { FileDocuments } from './file-documents.ts';

/** Opens the stores in the data directory. [SE-20] */
export function openStorage(dataDir: string): SessionStorage & {
  readonly grants: DocumentStore;
  settled(): Promise<void>;
} {
  const sessions = new FileDocuments(join(dataDir, 'sessions'), '.session');
  const modules = new FileDocuments(join(dataDir, 'modules'), '.pm');
  const running = new FileDocuments(join(dataDir, 'running'), '.session');
  const history = new FileDocuments(join(dataDir, 'history'), '.json');
  const grants = new FileDocuments(join(dataDir, 'grants'), '.json', true); // [AC-19]
  return {
    sessions,
    modules,
    running,
    history,
    grants,
    async settled() {
      await Promise.all(
        [sessions, modules, running, history, grants].map((store) => store.settled()),
      );
    },
  };
}
