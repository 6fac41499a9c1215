import type { Init, Session } from '@ubii/proto';
import { withoutPlaces } from '../text/session-spec.ts';
import { sessionText } from '../text/session-text.ts';

/** Ends the name of an exported session; the master's own files have it too. [SE-20] */
export const SESSION_FILE_ENDING = '.session';

/** A file to be kept. */
export interface TextFile {
  readonly name: string;
  readonly text: string;
}

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

/** Without signs that file systems do not like. */
export function fileName(name: string): string {
  return name
    .replaceAll(/[\\/:*?"<>|\p{Cc}]+/gu, '-')
    .replaceAll(/^[.\s-]+|[.\s-]+$/g, '')
    .slice(0, 100);
}
