import { join } from 'node:path';

import type { DocumentStore, SessionStorage, StudyStorage } from '../../core/ports/index.ts';
import { FileDocuments } from './file-documents.ts';

/** Opens the stores in the data directory. [SE-20] */
export function openStorage(dataDir: string): SessionStorage & {
  readonly grants: DocumentStore;
  readonly personalData: DocumentStore;
  readonly studyStorage: StudyStorage;
  settled(): Promise<void>;
} {
  const sessions = new FileDocuments(join(dataDir, 'sessions'), '.session');
  const modules = new FileDocuments(join(dataDir, 'modules'), '.pm');
  const running = new FileDocuments(join(dataDir, 'running'), '.session');
  const history = new FileDocuments(join(dataDir, 'history'), '.json');
  const grants = new FileDocuments(join(dataDir, 'grants'), '.json', true); // [AC-19]
  const personalData = new FileDocuments(join(dataDir, 'personal-data'), '.json'); // [PD-3]
  const studies = new FileDocuments(join(dataDir, 'studies'), '.json', true); // [ST-1]
  const runs = new FileDocuments(join(dataDir, 'study-runs'), '.json', true);
  return {
    sessions,
    modules,
    running,
    history,
    grants,
    personalData,
    studyStorage: { studies, runs },
    async settled() {
      await Promise.all(
        [sessions, modules, running, history, grants, personalData, studies, runs].map((store) =>
          store.settled(),
        ),
      );
    },
  };
}
