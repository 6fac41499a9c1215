import { ServiceError } from '@ubii/proto';
import type { ConnectionError } from './connection-error.ts';
import type { JoinProblem } from './join.ts';

const ASK = 'Ask an admin of the master for a new one.';

const JOINING: Readonly<Record<Exclude<JoinProblem, 'role'>, string>> = {
  missing:
    'The master admits this client only with a code or token. Set joinToken: the terminal of the master shows a code, and its admins make more.',
  wrong: `The master does not know this code or token. Check joinToken. ${ASK}`,
  expired: `The code or token expired. ${ASK}`,
  revoked: `The invitation was revoked. ${ASK}`,
  used: `The code or token was used as often as it may be. ${ASK}`,
  guessing: 'The master received too many wrong codes. Wait some seconds, and try again.',
};

const CHECK = 'Check the address, and that a master runs there.';

/** Returns what went wrong with a connection, and what to do about it. */
export function explainConnectionError(error: ConnectionError): string {
  const message = error.message.replace(/\.$/, '');
  switch (error.reason) {
    case 'refused':
    case 'timeout':
    case 'closed':
      // The reply of the master names the remedy.
      if (error.cause instanceof ServiceError) return `${message}.`;
      return `${message}. ${isOfFile() ? 'A page that was opened from a file needs a token as joinToken. ' : ''}${CHECK}`;
    case 'protocol':
      return `${message}. Check that the address is that of a Ubi-Interact master, and install the library that this master serves under /sdk/.`;
    case 'superseded':
      return 'Another program connected with the identity of this one. End one of them, or give each an identity of its own.';
    case 'disconnected':
      return `${message}. Ask an admin of the master before you connect again.`;
    case 'join': {
      const { joinProblem } = error;
      return joinProblem === undefined || joinProblem === 'role'
        ? `${message}.`
        : JOINING[joinProblem];
    }
  }
}

/** Whether this is a page without an origin. [AC-46] */
function isOfFile(): boolean {
  return (globalThis as { origin?: unknown }).origin === 'null';
}
