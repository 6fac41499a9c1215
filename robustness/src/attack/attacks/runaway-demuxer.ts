import { pause } from '../../pause.ts';
import { finding, type Attack } from '../attack.ts';
import { demuxSession, receives, topicsOf } from '../../fixtures/sessions.ts';

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
