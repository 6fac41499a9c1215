import type { CodeMark } from '../code/code-mark.ts';
import type { TextPlace } from '../../text/module-text.ts';

/** Texts shown for a problem of the module in the try-out. */
export interface FaultWords {
  readonly text: string;
  readonly place: TextPlace | undefined;
}

/**
 * Returns the texts for a problem. For one that is listed below the code, only a link to it.
 *
 * @param place position of the problem, if known
 * @param listed problems listed below the code
 */
export function faultWords(
  text: string,
  place: TextPlace | undefined,
  listed: readonly CodeMark[],
): FaultWords {
  const known = listed.find(
    ({ severity, isOfRun, message, line }) =>
      severity === 'error' && !isOfRun && (message === text || line === place?.line),
  );
  if (known === undefined) return { text, place };
  return { text: 'The code has an error.', place: known };
}
