import { MAX_NAME_LENGTH } from '../../connection/name-length.ts';

/** Returns why a client name is invalid, one sentence; `undefined` when the master accepts it. [EX-29] */
export function nameProblem(text: string): string | undefined {
  if (text.trim() === '') return 'Enter a name of at least one character.';
  if (text.trim().length > MAX_NAME_LENGTH) {
    return `The name has ${text.trim().length} characters; the maximum is ${MAX_NAME_LENGTH}.`;
  }
  // eslint-disable-next-line no-control-regex -- names are lines that are drawn and logged
  if (/[\u0000-\u001f\u007f]/.test(text.trim())) return 'Use one line without control characters.';
  return undefined;
}
