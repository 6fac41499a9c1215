import { AccessRole } from '@ubii/proto';

import { pause } from '../../pause.ts';
import { finding, seconds, type Attack } from '../attack.ts';
import { receives, periodicSession } from '../../fixtures/sessions.ts';

const TOPIC = '/revoked/tick';
const LIFETIME_MS = 60_000;
const DAY_MS = 24 * 3_600_000;

export const revoking: Attack = {
  name: 'revoking',
  about: 'what a participant left running publishes after its leave was taken back',
  async run(environment) {
    const first = await environment.startMaster();
    const participant = environment.outsider(first);
    const invitation = await environment.invite(first, AccessRole.ACCESS_ROLE_PARTICIPANT, {
      lifetimeMs: LIFETIME_MS,
    });
    const member = await participant.join(invitation.token);
    const outlivesMs =
      (member.client.extension?.credentialExpiresMs ?? 0) - invitation.grant!.expiresMs;
    const session = {
      ...periodicSession('left behind', TOPIC),
      extension: { startWithMaster: true },
    };
    for (const service of ['database/save', 'runtime/start']) {
      await participant.call({ topic: `/services/session/${service}`, session }, member.bearer);
    }
    await pause(1_000);
    const isRunning = await receives(first, `^${TOPIC}$`);
    if (!isRunning) throw new Error('The session of the participant did not run.');
    await first.call({
      topic: '/services/ubii/access_grant_revoke',
      accessGrantRevokeRequest: { grantId: invitation.grant!.id, reason: 'an attack' },
    });
    await pause(2_000);
    const publishes = await receives(first, `^${TOPIC}$`);
    await first.stop();
    const second = await environment.startMaster({ dataDir: first.dataDir });
    await pause(3_000);
    const comesBack = await receives(second, `^${TOPIC}$`);
    return [
      finding('its session publishes on', publishes ? 'yes' : 'no', 'no', !publishes),
      finding('and does after a restart', comesBack ? 'yes' : 'no', 'no', !comesBack),
      finding(
        'its credential would outlive a leave of a minute by',
        outlivesMs > DAY_MS ? `${(outlivesMs / DAY_MS).toFixed(1)} days` : seconds(outlivesMs),
        'nothing',
        outlivesMs <= 1_000,
      ),
    ];
  },
};
