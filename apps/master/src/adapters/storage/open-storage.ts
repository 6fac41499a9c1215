import { join } from 'node:path';

import type { DocumentStore, SessionStorage, StudyStorage } from '../../core/ports/index.ts';
import { FileDocuments } from './file-documents.ts';

/** Opens the studies of the data directory, readable by the master alone. [ST-1] */
export function openStudies(dataDir: string): {
  readonly studyStorage: StudyStorage;
  settled(): Promise<void>;
} {
  const studies = new FileDocuments(join(dataDir, 'studies'), '.json', true);
  const runs = new FileDocuments(join(dataDir, 'study-runs'), '.json', true);
  return {
    studyStorage: { studies, runs },
    async settled() {
      await Promise.all([studies.settled(), runs.settled()]);
    },
  };
}

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
  const { studyStorage, settled } = openStudies(dataDir);
  return {
    sessions,
    modules,
    running,
    history,
    grants,
    personalData,
    studyStorage,
    async settled() {
      await settled();
      await Promise.all(
        [sessions, modules, running, history, grants, personalData].map((store) => store.settled()),
      );
    },
  };
}
