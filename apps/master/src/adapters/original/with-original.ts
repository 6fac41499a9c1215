import type { SessionStorage } from '../../core/ports/index.ts';
import { LayeredDocuments } from './layered-documents.ts';
import type { OriginalData } from './read-original.ts';

/** Storage with the sessions and modules of an original installation under its own; those stay as they are. [SE-28] */
export function withOriginal<S extends SessionStorage>(
  storage: S,
  original: OriginalData | undefined,
): S {
  if (original === undefined) return storage;
  return {
    ...storage,
    sessions: new LayeredDocuments(storage.sessions, original.sessions),
    modules: new LayeredDocuments(storage.modules, original.modules),
  };
}
