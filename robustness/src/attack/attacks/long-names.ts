import { mib } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';

import { comparison, finding, type Attack } from '../attack.ts';

const NAME = 'n'.repeat(3_800_000);
const RUN_MS = 3_000;
const AT_ONCE = 4;
const MAX_BYTES = 2 * 1024 * 1024;

export const longNames: Attack = {
  name: 'long-names',
  about: 'a player registers with names of 3.8 MB for 3 s',
  async run(environment) {
    const master = await environment.startMaster();
    const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PLAYER);
    const endMs = performance.now() + RUN_MS;
    let taken = 0;
    const keepOn = async (index: number): Promise<void> => {
      const player = environment.outsider(master, index);
      while (performance.now() < endMs) {
        await player.join(token, { name: NAME }).then(
          () => taken++,
          () => {},
        );
      }
    };
    await Promise.all(Array.from({ length: AT_ONCE }, (_, index) => keepOn(index)));
    const reply = await environment
      .insider(master)
      .ask(
        'POST',
        '/services/json',
        { 'content-type': 'application/json' },
        '{"topic":"/services/ubii/master_status","masterStatusRequest":{"sinceMs":0}}',
      );
    const bytes = master.logBytes + reply.body.length;
    return [
      finding(
        'bytes of log and status',
        mib(bytes),
        `at most ${mib(MAX_BYTES)}`,
        bytes <= MAX_BYTES,
      ),
      comparison('registrations that were answered', String(taken)),
    ];
  },
};
