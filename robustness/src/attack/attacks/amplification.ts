import { createClient } from '@ubii/client-web/node';
import { mib } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';

import { pause } from '../../pause.ts';
import { comparison, finding, type Attack } from '../attack.ts';

const DEVICE_BYTES = 3_500_000;
const REQUESTS = 200;
const MAX_BYTES = 16 * 1024 * 1024;

export const amplification: Attack = {
  name: 'amplification',
  about: `a device of 3.5 MB, and ${REQUESTS} small registrations of its client, before one who watches clients`,
  async run(environment) {
    const master = await environment.startMaster();
    const watcher = createClient({ url: master.endpoints.url, name: 'watcher' });
    await watcher.connect();
    environment.closeLater(() => watcher.close());
    const subscription = watcher.subscribe({ regex: '^/ubii/client/' });
    await subscription.ready;
    const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PLAYER);
    const player = environment.outsider(master);
    const member = await player.join(token, { name: 'a' });
    const { client } = member;
    const parts = Array.from({ length: 16 }, (_, index) => index);
    let registered = 0;
    for (const index of parts) {
      const { error } = await player
        .call(
          {
            topic: '/services/device/registration',
            device: {
              name: `device ${index}`,
              clientId: client.id,
              description: 'd'.repeat(DEVICE_BYTES / parts.length),
            },
          },
          member.bearer,
        )
        .catch((refused: unknown) => ({ error: refused }));
      if (error === undefined) registered++;
    }
    const sentBefore = (await status()).bytesOut;
    for (let index = 0; index < REQUESTS; index++) {
      const { resumeToken = '' } = client.extension ?? {};
      await player
        .join(member.bearer, { id: client.id, name: `a${index % 2}`, extension: { resumeToken } })
        .catch(() => {});
    }
    await pause(2_000);
    const sent = (await status()).bytesOut - sentBefore;
    return [
      comparison('parts of the device taken', `${registered} of 16`),
      finding(
        'bytes sent to the watcher',
        mib(sent),
        `at most ${mib(MAX_BYTES)}`,
        sent <= MAX_BYTES,
      ),
    ];

    async function status() {
      const { masterStatus } = await master.call({
        topic: '/services/ubii/master_status',
        masterStatusRequest: { sinceMs: Date.now() + 1e9 },
      });
      return masterStatus!;
    }
  },
};
