import type { MasterProcess } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';

import { demuxing } from '../../fixtures/sessions.ts';
import { pause } from '../../pause.ts';
import type { PhoneWorld } from './phones.ts';
import type { Tally } from './tally.ts';

const RUN_MS = 400;
const INVITATION_MS = 5_000;

/** Starts a session whose demuxers make topics, stores it, and takes all of it away again. */
export async function runSession(master: MasterProcess, name: string, tally: Tally): Promise<void> {
  const wanted = demuxing(name, 4);
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
  tally.done('sessions');
}

/** Makes invitations for phones, and revokes those with which they joined before. */
export async function inviteAnew(world: PhoneWorld): Promise<void> {
  const before = world.token === '' ? undefined : grants.get(world);
  const { accessGrantCreated } = await world.master.call({
    topic: '/services/ubii/access_grant_create',
    accessGrantCreateRequest: { label: 'phones', role: AccessRole.ACCESS_ROLE_PLAYER },
  });
  world.token = accessGrantCreated!.token;
  grants.set(world, accessGrantCreated!.grant!.id);
  world.tally.done('invitations');
  await pause(INVITATION_MS);
  if (before !== undefined) {
    await world.master.call({
      topic: '/services/ubii/access_grant_revoke',
      accessGrantRevokeRequest: { grantId: before, reason: 'another one is there' },
    });
  }
}

const grants = new WeakMap<PhoneWorld, string>();

/** Looks at everything, as a page of the operator does. */
export async function look(master: MasterProcess, tally: Tally): Promise<void> {
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
  tally.done('looks at all lists');
  await pause(250);
}
