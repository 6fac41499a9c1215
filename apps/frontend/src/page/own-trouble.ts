import type { StatusProblem } from '@ubii/proto';

/** Problem that concerns the user of this page, and its cause. */
export interface OwnTrouble {
  /** Stable while the problem lasts. */
  readonly key: string;
  readonly code: string;
  /** Problem and consequence. */
  readonly text: string;
  readonly remedy: string;
  /** Id of the session; empty when it concerns this page itself. */
  readonly sessionId: string;
}

/** Problems that this page causes or suffers. That it is silent, it cannot show. [EX-18] [EX-46] [EX-47] */
const OF_CLIENT: ReadonlySet<string> = new Set([
  'client_throttled',
  'publisher_noisy',
  'master_busy',
  'module_slow',
  'client_slow',
  'limit_reached',
  'protocol_errors',
]);
/** Problems that are shown to users of the session, independent of where its modules run. */
const OF_SESSION: ReadonlySet<string> = new Set(['module_slow', 'machine_busy']);

/**
 * Returns the problems of this page: of its client, the modules it runs, and the session that is open in it.
 * @param own this page's client, with its name
 * @param openSession id of the open session, if any
 */
export function ownTroubles(
  problems: readonly StatusProblem[],
  own: { readonly id: string; readonly name: string | undefined },
  openSession: string | undefined,
): OwnTrouble[] {
  return problems
    .filter(({ code, clientId, sessionId }) => {
      const isMine = own.id !== '' && clientId === own.id && OF_CLIENT.has(code);
      return isMine || (openSession === sessionId && sessionId !== '' && OF_SESSION.has(code));
    })
    .map(({ code, text, remedy, clientId, sessionId, moduleId }) => ({
      key: `${code} ${clientId} ${sessionId} ${moduleId}`,
      code,
      text: asOwn(text, own.name),
      remedy: asOwnRemedy(remedy, code),
      sessionId,
    }));
}

/** Rewrites “Mara publishes” for Mara as what this page does. */
function asOwn(text: string, name: string | undefined): string {
  return name && text.startsWith(`${name} `) ? `This page ${text.slice(name.length + 1)}` : text;
}

/** Remedies for the user of the page instead of the operator of the master. */
function asOwnRemedy(remedy: string, code: string): string {
  return OWN_REMEDIES[code] ?? remedy;
}

const OWN_REMEDIES: Readonly<Record<string, string>> = {
  publisher_noisy:
    'Publish fewer or smaller records: check repeated publishing, cameras and fast modules in this tab.',
  client_throttled: 'Publish fewer records, or ask an admin to remove the throttle.',
  client_slow: 'Close views of fast topics or images, or use a faster network.',
};
