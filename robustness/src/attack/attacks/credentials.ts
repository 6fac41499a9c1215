import type { MasterProcess, Outsider } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';

import { receives, periodicSession } from '../../fixtures/sessions.ts';
import { pause } from '../../pause.ts';
import { finding, seconds, type Attack, type Finding } from '../attack.ts';
import type { AttackEnvironment } from '../environment/attack-environment.ts';

const TIMEOUT_MS = 75_000;
const MAX_WAIT_MS = 10_000;

export const wrongCodes: Attack = {
  name: 'wrong-codes',
  about:
    'wrong codes from one IPv6 address, and from 20 IPv4 addresses, while others have right ones',
  async run(environment) {
    const findings: Finding[] = [];
    if (environment.hasNetwork) {
      const master = await environment.startMaster();
      await guess(environment.outsider(master, 0, 6), 30);
      const neighbour = await timeUntilIn(
        environment,
        master,
        environment.outsider(master, 1, 6),
        'code',
      );
      findings.push(outcome('a right code from a neighbour of the same /64 (IPv6)', neighbour));
      await environment.clear();
    }
    const master = await environment.startMaster();
    await Promise.all(
      Array.from({ length: 20 }, (_, index) => guess(environment.outsider(master, index), 30)),
    );
    const other = await timeUntilIn(environment, master, environment.outsider(master, 45), 'code');
    findings.push(outcome('a right code from another IPv4 address', other));
    const scanned = await timeUntilIn(
      environment,
      master,
      environment.outsider(master, 0),
      'token',
    );
    findings.push(outcome('a token from an address that guessed', scanned));
    return findings;
  },
};

function outcome(what: string, waitedMs: number | undefined): Finding {
  const figure = waitedMs === undefined ? `not within ${seconds(TIMEOUT_MS)}` : seconds(waitedMs);
  const holds = waitedMs !== undefined && waitedMs <= MAX_WAIT_MS;
  return finding(`${what}: time until in`, figure, `at most ${seconds(MAX_WAIT_MS)}`, holds);
}

async function guess(stranger: Outsider, times: number): Promise<void> {
  for (let index = 0; index < times; index++) {
    const token = `ABCD-${String(2000 + index)}`;
    const asked = stranger
      .call({ topic: '/services/ubii/join_check', joinCheckRequest: { token } })
      .catch(() => {});
    // A slowed client gets no answer for a while: an attacker does not wait.
    await Promise.race([asked, pause(300)]);
  }
}

/** Tries once a second, as a person does. */
async function timeUntilIn(
  environment: AttackEnvironment,
  master: MasterProcess,
  caller: Outsider,
  by: 'code' | 'token',
): Promise<number | undefined> {
  const invitation = await environment.invite(master, AccessRole.ACCESS_ROLE_PLAYER);
  const begunMs = performance.now();
  while (performance.now() - begunMs < TIMEOUT_MS) {
    const isIn = await caller.join(invitation[by]).then(
      () => true,
      () => false,
    );
    if (isIn) return performance.now() - begunMs;
    await pause(1_000);
  }
  return undefined;
}

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
