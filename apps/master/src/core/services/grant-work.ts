import { StatusEventKind } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import type { Dismissal } from '../clients/dismissals.ts';
import type { Core } from '../areas/core.ts';
import { quote } from '../texts/quote.ts';
import type { Grant, GrantWork } from '../access/grant.ts';

/** Dependencies of ending a grant. */
export type GrantWorkContext = Pick<Core, 'sessions' | 'sessionLibrary' | 'modules' | 'clients'> &
  Pick<Core, 'access' | 'kept' | 'events' | 'clock' | 'log'>;

/** Interval of checks for expired invitations, milliseconds. */
const LOOK_INTERVAL_MS = 1_000;

/** Sessions and modules that were created or changed with a grant [AC-90]. */
export function workOf(
  { sessions, sessionLibrary, modules }: GrantWorkContext,
  { id }: Grant,
): GrantWork {
  const made = sessions.madeWith(id);
  return {
    sessionIds: made.map((session) => session.id),
    runningSessionIds: made.filter(({ isLive }) => isLive).map((session) => session.id),
    storedSessionNames: sessionLibrary
      .list()
      .filter(({ extension }) => extension?.grantIds.includes(id))
      .map(({ name }) => name),
    moduleNames: modules.madeWith(id),
  };
}

/** Ids of the clients that joined with a grant and are registered. */
export function clientIdsOf({ clients }: GrantWorkContext, grant: Grant): string[] {
  return [...clients.values()].flatMap(({ id, access }) => (access.grant === grant ? [id] : []));
}

/** The grant, and those that were made with it, and with those [AC-93]. */
export function withDescendants({ access }: GrantWorkContext, grant: Grant): Grant[] {
  const all = [grant];
  const others = access.grants.list();
  for (const one of all) {
    all.push(...others.filter((other) => other.madeWith === one.id && !all.includes(other)));
  }
  return all;
}

/**
 * Ends the clients of a grant, and their work: sessions stop, or the work is the operator's from
 * now on [AC-92]. All but what is written down has happened when this returns.
 */
export async function endGrant(
  core: GrantWorkContext,
  grant: Grant,
  dismissal: Dismissal,
  isHandedOver: boolean,
): Promise<void> {
  const { sessions, sessionLibrary, modules } = core;
  for (const id of clientIdsOf(core, grant)) {
    const client = core.clients.get(id)!;
    // Each master ends those that are there. [CU-27]
    if (client.home?.isLost !== false) core.clients.dismiss(client, dismissal);
  }
  core.kept.deleteOfInvitation(grant.id); // [TD-46]
  if (isHandedOver) {
    for (const session of sessions.madeWith(grant.id)) sessions.handOver(session, grant.id);
    await sessionLibrary.handOver(grant.id);
    await modules.handOver(grant.id);
    return;
  }
  for (const session of sessions.madeWith(grant.id)) {
    if (!session.isLive) continue;
    sessions.stop(session);
    core.events.add(
      StatusEventKind.SESSION_DEGRADED,
      `The session ${quote(session.label)} was stopped: the invitation of the client that started it has ended`,
    );
  }
}

/** Ends grants when their time is over [AC-91], and those that another master revoked. @returns what makes it stop */
export function watchGrants(core: GrantWorkContext): Cancel {
  const look = (): void => {
    for (const grant of core.access.grants.takeOver()) {
      void endGrant(core, grant, { reason: 'expired' }, false); // writes nothing
      core.log.info('an invitation expired', { invitation: grant.label || grant.id });
    }
  };
  look();
  core.access.grants.onRevoked.add((grant) => {
    // The master that revoked it hands over what is stored. [CU-27]
    endGrant(core, grant, { reason: 'revoked' }, grant.isHandedOver).catch((error: unknown) =>
      core.log.warn('what was made with an invitation could not be handed over', {
        reason: String(error),
      }),
    );
  });
  return core.clock.every(LOOK_INTERVAL_MS, look);
}
