import type { CodeMark } from '../code/code-mark.ts';
import type { TextPlace } from '../text/module-text.ts';

/** What stands at a fault of the module that is tried. */
export interface FaultWords {
  readonly text: string;
  readonly place: TextPlace | undefined;
}

/**
 * A mistake that is told below the code is not told a second time: the try-out leads to it.
 *
 * @param place where it went wrong, if that is known
 * @param listed what stands below the code
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
