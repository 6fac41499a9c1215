import { isLongerThan } from '../texts/text-length.ts';

/** Maximum size of the reason of a close frame besides its code (RFC 6455, section 5.5.1). */
const MAX_REASON_BYTES = 123;

/** A text as it fits into a close frame, cut between characters. */
export function closeReason(text: string): string {
  if (!isLongerThan(text, MAX_REASON_BYTES)) return text;
  const characters = [...text.slice(0, MAX_REASON_BYTES)];
  while (isLongerThan(`${characters.join('')}…`, MAX_REASON_BYTES)) characters.pop();
  return `${characters.join('')}…`;
}
