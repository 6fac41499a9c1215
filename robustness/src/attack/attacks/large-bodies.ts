import { mib } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';

import { comparison, finding, millis, type Attack, type Finding } from '../attack.ts';
import { LARGE_BODIES } from '../parts/large-bodies.ts';

/** The aim of the issue: a body of nobody delays records for longer. A busy machine adds its own delays. */
const MAX_DELAY_MS = 25;
const MAX_PEAK_BYTES = 400 * 1024 * 1024;

export const largeBodies: Attack = {
  name: 'large-bodies',
  about: 'JSON bodies of 31 MiB in three shapes, of a stranger and of a participant',
  async run(environment) {
    const findings: Finding[] = [];
    const bodies = Object.entries(LARGE_BODIES).map(([shape, make]) => [shape, make()] as const);
    for (const who of ['stranger', 'participant'] as const) {
      const master = await environment.startMaster();
      const meter = await environment.gapMeter(master);
      const calmMs = await meter.during(async () => {});
      findings.push(comparison(`${who}: stall before it`, millis(calmMs)));
      const caller = environment.outsider(master);
      const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
      const member = who === 'participant' ? await caller.join(token) : undefined;
      for (const [shape, body] of bodies) {
        const headers = {
          'content-type': 'application/json',
          ...(member && { authorization: `Bearer ${member.bearer}` }),
        };
        const longestMs = await meter.during(() =>
          caller.ask('POST', '/services/json', headers, body),
        );
        findings.push(
          finding(
            `${who}, ${shape}: stall of records`,
            millis(longestMs),
            `at most ${MAX_DELAY_MS} ms, or as before it`,
            longestMs <= Math.max(MAX_DELAY_MS, 2 * calmMs),
          ),
        );
      }
      const { peakBytes = 0 } = master.figures();
      findings.push(
        finding(
          `${who}: most resident`,
          mib(peakBytes),
          `at most ${mib(MAX_PEAK_BYTES)}`,
          peakBytes <= MAX_PEAK_BYTES,
        ),
      );
      await environment.clear();
    }
    return findings;
  },
};
