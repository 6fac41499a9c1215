import type { Init, Session } from '@ubii/proto';
import { fileName, type TextFile } from '../../files/text-file.ts';
import { withoutPlaces } from '../text/session-spec.ts';
import { sessionText } from '../text/session-text.ts';

/** Ends the name of an exported session; the master's own files have it too. [SE-20] */
export const SESSION_FILE_ENDING = '.session';

/**
 * A session as one file with the source of every module in it. Places are left out: the nodes of this
 * room are not in another.
 */
export function exportSession(spec: Init<Session>): TextFile {
  return {
    name: `${fileName(spec.name ?? '') || 'session'}${SESSION_FILE_ENDING}`,
    text: sessionText(withoutPlaces(spec)),
  };
}
