import type { Session } from '@ubii/proto';
import { withEditorJson } from '../session-details.ts';

/**
 * Returns a changed session with its earlier editor data, if the change has none: clients that do not know it may send
 * sessions back without it. [EX-22]
 * @param before the newest session known to have editor data
 */
export function keepEditorData(changed: Session, before: Session): Session {
  const had = before.extension?.editorJson ?? '';
  const has = changed.extension?.editorJson ?? '';
  return has === '' && had !== '' ? withEditorJson(changed, had) : changed;
}
