import type { ProcessingModule, Session } from '@ubii/proto';
import type { ReadFile } from '../../../sessions/file/read-session-file.ts';
import { completeSession, withPlaceholders } from '../../model/complete-session.ts';

/** A parsed file that can become a session, with its warnings; or the reason why it cannot. */
export type PreparedFile =
  | {
      readonly kind: 'ready';
      readonly name: string;
      readonly session: Session;
      /** Names of unknown modules. */
      readonly missing: readonly string[];
      /** Warnings about contents that are not understood, one sentence each. */
      readonly doubts: readonly string[];
    }
  | Extract<ReadFile, { kind: 'broken' }>;

/** @param library known modules; `undefined` when the master did not answer, so that no module counts as missing */
export function preparedFile(
  file: ReadFile,
  library: readonly ProcessingModule[] | undefined,
  uuid: () => string,
): PreparedFile {
  if (file.kind === 'broken') return file;
  const { session, missing } =
    library === undefined
      ? { session: file.session, missing: [] }
      : withPlaceholders(completeSession(file.session, library), library, uuid);
  return {
    kind: 'ready',
    name: file.name,
    session,
    missing,
    doubts: file.problems.map(({ line, message }) =>
      line === undefined ? message : `Line ${line}: ${message}`,
    ),
  };
}
