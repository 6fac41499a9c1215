import type { Init, Session } from '@ubii/proto';
import { fileName, type TextFile } from '../../files/text-file.ts';
import { withoutPlaces } from '../text/session-spec.ts';
import { sessionText } from '../text/session-text.ts';

/** Filename extension of an exported session, the same as for the master's own files. [SE-20] */
export const SESSION_FILE_ENDING = '.session';

/**
 * Exports a session as a file, with the source of its modules. Node assignments are omitted, because nodes differ
 * between installations.
 */
export function exportSession(spec: Init<Session>): TextFile {
  return {
    name: `${fileName(spec.name ?? '') || 'session'}${SESSION_FILE_ENDING}`,
    text: sessionText(withoutPlaces(spec)),
  };
}
