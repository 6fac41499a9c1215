import { isLongerThan } from '@ubii/words';
import type { ClientEnding, CloseReason } from '../../core/ports/index.ts';

/** Codes of the close frame for each reason of the master. Those from 4000 on are ours: docs/spec/extensions.md. */
const CODES: Readonly<Record<CloseReason, number>> = {
  deregistered: 1000,
  'master is closing': 1001,
  superseded: 4001,
  'not this client': 4003,
  'unknown client': 4004,
  'protocol errors': 4008,
  'too slow': 4009,
  disconnected: 4010,
  revoked: 4011,
  expired: 4012,
  'too many': 4013,
};

/** Code with which a client says that it leaves permanently. [EX-55] */
const LEFT = 4000;

/** Maximum size of the text of a close frame besides its code (RFC 6455, section 5.5.1). */
const MAX_TEXT_BYTES = 123;

/** Words for reasons that are not told as they are named. */
const WORDS: Partial<Readonly<Record<CloseReason, string>>> = {
  expired: 'the invitation expired',
};

/** What the close frame of a WebSocket holds. */
export interface CloseFrame {
  readonly code: number;
  readonly text: string;
}

/** The close frame for a reason: the explanation, where there is one, says more than its name. */
export function closeFrame(reason: CloseReason, explanation?: string): CloseFrame {
  return { code: CODES[reason], text: fit(explanation ?? WORDS[reason] ?? reason) };
}

/** How a client ended its socket. @param code that of its close frame, if one came */
export function endingOf(code: number | undefined): ClientEnding {
  return code === LEFT ? 'left' : 'lost';
}

/** Cut between characters. */
function fit(text: string): string {
  if (!isLongerThan(text, MAX_TEXT_BYTES)) return text;
  const characters = [...text.slice(0, MAX_TEXT_BYTES)];
  while (isLongerThan(`${characters.join('')}…`, MAX_TEXT_BYTES)) characters.pop();
  return `${characters.join('')}…`;
}
