import { mib } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';

import { demuxSession, receives, topicsOf } from '../../fixtures/sessions.ts';
import { pause } from '../../pause.ts';
import { comparison, finding, type Attack } from '../attack.ts';

const MODULES = 60;
/** The budget of one session is 1 GiB; the rest is the master itself. */
const MAX_BYTES = 1_280 * 1024 * 1024;

export const moduleMemory: Attack = {
  name: 'module-memory',
  about: `a session of a participant with ${MODULES} modules that each take what they get`,
  async run(environment) {
    const master = await environment.startMaster();
    const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const participant = environment.outsider(master);
    const member = await participant.join(token);
    const modules = Array.from({ length: MODULES }, (_, index) => ({
      name: `hoarder ${index}`,
      processingMode: { frequency: { hertz: 10 } },
      onCreatedStringified: '(state) => { state.kept = []; }',
      onProcessingStringified: `(deltaTime, inputs, state) => {
        if (state.kept.length < 40) state.kept.push(new Uint8Array(1024 * 1024).fill(1));
        return {};
      }`,
    }));
    const { session, error } = await participant.call(
      {
        topic: '/services/session/runtime/start',
        session: { name: 'hoarders', processingModules: modules },
      },
      member.bearer,
    );
    await pause(20_000);
    const { peakBytes = 0 } = master.figures();
    return [
      finding('most resident', mib(peakBytes), `at most ${mib(MAX_BYTES)}`, peakBytes <= MAX_BYTES),
      comparison(
        'the session',
        session === undefined ? `refused: ${error?.message ?? ''}` : 'started',
      ),
    ];
  },
};

const RUN_MS = 15_000;

export const runawayDemuxer: Attack = {
  name: 'runaway-demuxer',
  about: 'a session whose demuxer makes ever new topics',
  async run(environment) {
    const master = await environment.startMaster();
    const { session } = await master.call({
      topic: '/services/session/runtime/start',
      session: demuxSession('runaway', 2_000),
    });
    await pause(RUN_MS);
    const topics = await topicsOf(master);
    const { session: other } = await master.call({
      topic: '/services/session/runtime/start',
      session: demuxSession('other', 1),
    });
    const others = await receives(master, '^/other/');
    await master.call({ topic: '/services/session/runtime/stop', session: { id: other!.id } });
    await master.call({ topic: '/services/session/runtime/stop', session: { id: session!.id } });
    await pause(2_000);
    const left = await topicsOf(master);
    return [
      finding('topics after 15 s', String(topics), 'at most 20 000', topics <= 20_000),
      finding('another session gets new topics', others ? 'yes' : 'no', 'yes', others),
      finding('topics after it was stopped', String(left), 'at most 1 000', left <= 1_000),
    ];
  },
};
