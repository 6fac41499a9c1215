import type { MasterProcess } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';

import { demuxSession } from '../../fixtures/sessions.ts';
import { pause } from '../../pause.ts';
import type { PhoneSetup } from './phones.ts';
import type { Counters } from './counters.ts';

const RUN_MS = 400;
const INVITATION_MS = 5_000;

/** Starts a session whose demuxers make topics, stores it, and takes all of it away again. */
export async function runSession(
  master: MasterProcess,
  name: string,
  counters: Counters,
): Promise<void> {
  const wanted = demuxSession(name, 4);
  const { sessionList } = await master.call({
    topic: '/services/session/database/save',
    session: wanted,
  });
  const { id } = sessionList!.elements[0]!;
  const { session } = await master.call({
    topic: '/services/session/runtime/start',
    session: { id },
  });
  await pause(RUN_MS);
  await master.call({ topic: '/services/session/runtime/stop', session: { id: session!.id } });
  await master.call({ topic: '/services/session/runtime/remove', session: { id: session!.id } });
  await master.call({ topic: '/services/session/database/delete', session: { id } });
  counters.done('sessions');
}

/** Makes invitations for phones, and revokes those with which they joined before. */
export async function renewInvitation(setup: PhoneSetup): Promise<void> {
  const before = setup.token === '' ? undefined : grants.get(setup);
  const { accessGrantCreated } = await setup.master.call({
    topic: '/services/ubii/access_grant_create',
    accessGrantCreateRequest: { label: 'phones', role: AccessRole.ACCESS_ROLE_PLAYER },
  });
  setup.token = accessGrantCreated!.token;
  grants.set(setup, accessGrantCreated!.grant!.id);
  setup.counters.done('invitations');
  await pause(INVITATION_MS);
  if (before !== undefined) {
    await setup.master.call({
      topic: '/services/ubii/access_grant_revoke',
      accessGrantRevokeRequest: { grantId: before, reason: 'another one is there' },
    });
  }
}

const grants = new WeakMap<PhoneSetup, string>();

/** Looks at everything, as a page of the operator does. */
export async function listEverything(master: MasterProcess, counters: Counters): Promise<void> {
  for (const topic of [
    '/services/topic_list',
    '/services/client/get_list',
    '/services/device/get_list',
    '/services/session/runtime/get_list',
    '/services/ubii/access_grant_list',
  ]) {
    await master.call({ topic });
  }
  await master.call({ topic: '/services/ubii/master_status', masterStatusRequest: { sinceMs: 0 } });
  await master.call({ topic: '/services/ubii/log_tail', logRequest: {} });
  counters.done('looks at all lists');
  await pause(250);
}
