import { ServiceError } from '@ubii/proto';
import { quote } from '../texts/quote.ts';

/** Most characters of a code or of a visit. [ST-11] */
const MAX_CHARACTERS = 32;
const LABEL = /^[A-Za-z0-9]+$/;

/** @param member name of the member of the request @throws ServiceError when the text is no label [ST-11] */
export function requireLabel(member: string, text: string): string {
  if (text.length <= MAX_CHARACTERS && LABEL.test(text)) return text;
  throw new ServiceError(
    'invalid_argument',
    `The member ${member} is ${quote(text)}. Set it to 1 to ${MAX_CHARACTERS} letters from A to Z and digits, such as P01.`,
  );
}

/** Whether two codes are those of one participant. [ST-11] */
export function isSameCode(a: string, b: string): boolean {
  return a.toLowerCase() === b.toLowerCase();
}
