import { createClient, type UbiiClient } from '@ubii/client-web/node';
import type { MasterProcess, Member, Outsider } from '@ubii/harness';
import { AccessRole, encode, ReplayConflict, StudyRunAction } from '@ubii/proto';
import type { Init, Replay, ReplayStartRequest } from '@ubii/proto';
import { recordedDevice } from '@ubii/recording/testing';

import { recordingFile, uploadRecording } from '../../fixtures/recordings.ts';
import { pause } from '../../pause.ts';
import { comparison, finding, type Attack, type Finding } from '../attack.ts';
import type { AttackEnvironment } from '../environment/attack-environment.ts';

/** Value of live records; a replay has others. */
const LIVE = -7;
const PERIOD_MS = 50;
const WATCH_MS = 2_000;

export const replayRights: Attack = {
  name: 'replay-rights',
  about: 'a replay of a participant mutes and moves topics of others',
  async run(environment) {
    const master = await environment.startMaster();
    const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const attacker = environment.outsider(master);
    const member = await attacker.join(token, { name: 'attacker' });
    const admin = await openClient(environment, master, 'admin');
    const player = environment.outsider(master, 1);
    const playerMember = await player.join(token, { name: 'neighbour' });
    const findings: Finding[] = [];

    const stopAdmin = publishAsAdmin(admin, '/lamp');
    const lamp = { topic: '/lamp', conflict: ReplayConflict.REPLAY_CONFLICT_MUTE_LIVE };
    const mutesAdmin = (await watchDuring(lamp, '^/lamp$')) === 0;
    findings.push(yesNo('it mutes a topic of an admin', mutesAdmin));
    stopAdmin();

    const own = `/${playerMember.client.id}/touch`;
    const stopPlayer = await publishAsGuest(player, playerMember, own);
    const touch = { topic: own, conflict: ReplayConflict.REPLAY_CONFLICT_MUTE_LIVE };
    const mutesOwn = (await watchDuring(touch, `^${own}$`)) === 0;
    findings.push(yesNo('it mutes a topic that belongs to another client', mutesOwn));
    stopPlayer();

    const stopShared = await publishAsGuest(player, playerMember, '/shared');
    for (const livePrefix of ['/ubii/x', '/info/x', `/${admin.id}`]) {
      const conflict = ReplayConflict.REPLAY_CONFLICT_MOVE_LIVE;
      const moved = await watchDuring(
        { topic: '/shared', conflict, livePrefix },
        `^${livePrefix}/`,
      );
      const where = livePrefix === `/${admin.id}` ? 'topics of another client' : `${livePrefix}/…`;
      findings.push(yesNo(`it moves live records to ${where}`, moved > 0));
    }
    stopShared();
    return findings;

    /** Plays a file with a topic, and counts live records that arrive meanwhile. */
    async function watchDuring(
      wish: Init<ReplayStartRequest> & { readonly topic: string },
      regex: string,
    ): Promise<number> {
      const { topic, ...request } = wish;
      const file = await recordingFile(topic, 50);
      const { recording } = await uploadRecording(attacker, file, { bearer: member.bearer });
      if (recording === undefined) throw new Error('The upload was refused.');
      const started = await startReplay(attacker, member, {
        ...request,
        recordingId: recording.id,
        isLooping: true,
      });
      if (started === undefined) return request.livePrefix === undefined ? 1 : 0;
      // A replay mutes topics that it has played.
      await pause(500);
      const count = await countLive(environment, master, regex);
      await attacker.call(
        { topic: '/services/ubii/replay_stop', replayRequest: { id: started.id } },
        member.bearer,
      );
      return count;
    }
  },
};

export const studyCodes: Attack = {
  name: 'study-codes',
  about: 'a viewer reads the code of a participant while a recording of a study is replayed',
  async run(environment) {
    const code = 'QZ77X';
    const master = await environment.startMaster();
    const { study } = await master.call({
      topic: '/services/ubii/study_save',
      study: { name: 'reach', repetitions: 1, conditions: [{ name: 'one' }] },
    });
    const { studyRun } = await master.call({
      topic: '/services/ubii/study_run_start',
      studyRunStartRequest: { studyId: study!.id, participantCode: code, visit: '1' },
    });
    const publisher = await openClient(environment, master, 'publisher');
    const stop = publishAsAdmin(publisher, '/reach');
    const change = (action: StudyRunAction) =>
      master.call({
        topic: '/services/ubii/study_run_change',
        studyRunChangeRequest: { runId: studyRun!.id, action },
      });
    await change(StudyRunAction.STUDY_RUN_ACTION_BEGIN_BLOCK);
    await pause(1_000);
    await change(StudyRunAction.STUDY_RUN_ACTION_END_BLOCK);
    stop();
    const { recordingList } = await master.call({ topic: '/services/ubii/recording_list' });
    const recordingId = recordingList!.elements[0]!.id;
    const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_VIEWER);
    const viewer = environment.outsider(master);
    const member = await viewer.join(token, { name: 'viewer' });
    const seen: string[] = [];
    const socket = await viewer.openSocket(member);
    socket.on('message', (data) => seen.push((data as Buffer).toString('latin1')));
    await viewer.call(
      {
        topic: '/services/topic_subscription',
        topicSubscription: { clientId: member.client.id, subscribeTopics: ['/ubii/replays'] },
      },
      member.bearer,
    );
    const { replay } = await master.call({
      topic: '/services/ubii/replay_start',
      replayStartRequest: { recordingId, isLooping: true },
    });
    await pause(1_000);
    const shows = async (topic: string): Promise<boolean> =>
      JSON.stringify(await viewer.call({ topic }, member.bearer)).includes(code);
    const findings = [
      comparison('replays that a viewer is told of', String(seen.length > 0 ? 'some' : 'none')),
      yesNo(
        'the code is on /ubii/replays',
        seen.some((text) => text.includes(code)),
      ),
      yesNo('the code is in replay_list', await shows('/services/ubii/replay_list')),
      yesNo('the code is in recording_list', await shows('/services/ubii/recording_list')),
      yesNo('the code is in the list of clients', await shows('/services/client/get_list')),
    ];
    await master.call({
      topic: '/services/ubii/replay_stop',
      replayRequest: { id: replay!.id },
    });
    return findings;
  },
};

export const ghostInputs: Attack = {
  name: 'ghost-inputs',
  about: 'a ghost of a participant whose devices subscribe to topics of others',
  async run(environment) {
    const master = await environment.startMaster();
    const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const attacker = environment.outsider(master);
    const member = await attacker.join(token, { name: 'attacker' });
    const victim = await openClient(environment, master, 'victim');
    const claimed = ['/ubii/x', '/info/x', `/${victim.id}/vibrate`];
    const components = [
      { topic: '/recorded/touch' },
      ...claimed.map((topic) => ({ topic, direction: 'subscriber' })),
    ];
    const value = recordedDevice('phone', 'recorded', components);
    const timeNs = BigInt(Date.now() - 3_600_000) * 1_000_000n;
    const file = await recordingFile('/recorded/touch', 50, [{ kind: 'device', timeNs, value }]);
    const { recording } = await uploadRecording(attacker, file, { bearer: member.bearer });
    const replay = await startReplay(attacker, member, {
      recordingId: recording!.id,
      isGhost: true,
    });
    await pause(1_000);
    const { deviceList } = await master.call({ topic: '/services/device/get_list' });
    const topics = deviceList!.elements
      .filter(({ clientId }) => clientId !== victim.id)
      .flatMap((device) => device.components.map(({ topic }) => topic));
    return [
      comparison('the ghost', replay === undefined ? 'refused' : 'plays'),
      ...claimed.map((topic) =>
        yesNo(
          `its devices claim ${topic.includes(victim.id) ? 'a topic of another client' : topic}`,
          topics.includes(topic),
        ),
      ),
    ];
  },
};

/** A finding that holds when something does not happen. */
function yesNo(what: string, happens: boolean): Finding {
  return finding(what, happens ? 'yes' : 'no', 'no', !happens);
}

async function openClient(
  environment: AttackEnvironment,
  master: MasterProcess,
  name: string,
): Promise<UbiiClient> {
  const client = createClient({ url: master.endpoints.url, name, publishIntervalMs: 0 });
  await client.connect();
  environment.closeLater(() => client.close());
  return client;
}

/** @returns ends it */
function publishAsAdmin(client: UbiiClient, topic: string): () => void {
  const timer = setInterval(() => client.publish(topic, 'double', LIVE), PERIOD_MS);
  return () => clearInterval(timer);
}

/** @returns ends it */
async function publishAsGuest(caller: Outsider, member: Member, topic: string) {
  const socket = await caller.openSocket(member);
  const frame = encode('ubii.topicData.TopicData', { topicDataRecord: { topic, double: LIVE } });
  const timer = setInterval(() => socket.send(frame), PERIOD_MS);
  return (): void => {
    clearInterval(timer);
    socket.terminate();
  };
}

/** Counts live records for a while, beyond the value that the master kept. */
async function countLive(
  environment: AttackEnvironment,
  master: MasterProcess,
  regex: string,
): Promise<number> {
  const client = await openClient(environment, master, 'watcher');
  let count = 0;
  const subscription = client.subscribe({ regex });
  subscription.onRecord(({ value }) => {
    if (value === LIVE) count++;
  });
  await subscription.ready;
  await pause(300);
  const kept = count;
  await pause(WATCH_MS);
  await client.close();
  return count - kept;
}

async function startReplay(
  caller: Outsider,
  { client, bearer }: Member,
  request: Init<ReplayStartRequest>,
): Promise<Replay | undefined> {
  const { replay } = await caller.call(
    {
      topic: '/services/ubii/replay_start',
      replayStartRequest: { clientId: client.id, ...request },
    },
    bearer,
  );
  return replay;
}
