import { spawnSync } from 'node:child_process';
import {
  chmodSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createClient } from '@ubii/client-web/node';
import type { Init, ServiceRequest } from '@ubii/proto';

import { recordingFile, startRecording } from '../../fixtures/recordings.ts';
import { pause } from '../../pause.ts';
import { comparison, finding, type Attack, type Finding } from '../attack.ts';

const NOBODY = 65_534;
const FLIGHT_MS = 3_000;
const RECORDS = 100;

export const fileModes: Attack = {
  name: 'file-modes',
  about: 'another user of this machine reads recordings in the data directory',
  async run(environment) {
    const dataDir = mkdtempSync(join(tmpdir(), 'ubii-modes-'));
    environment.closeLater(() => rmSync(dataDir, { recursive: true, force: true }));
    // As a folder that a user makes with the usual mask.
    chmodSync(dataDir, 0o755);
    const folder = join(dataDir, 'recordings');
    mkdirSync(folder, { mode: 0o755 });
    const earlier = join(folder, 'earlier.mcap');
    writeFileSync(earlier, await recordingFile('/earlier', 10), { mode: 0o644 });
    const master = await environment.startMaster({ dataDir });
    const id = await startRecording(master, 'private');
    await pause(500);
    const during = whatOthersRead(folder);
    await master.call({ topic: '/services/ubii/recording_stop', recordingRequest: { id } });
    await master.call({ topic: '/services/ubii/recording_list' });
    const warns = master.log.some((line) => /other users .* data directory/i.test(line));
    return [
      mode('the folder of recordings', folder, 0o700),
      mode('a recording', join(folder, `${id}.mcap`), 0o600),
      mode('a recording of an earlier start', earlier, 0o600),
      ...during,
      finding('a warning for a data directory that others can read', yes(warns), 'yes', warns),
    ];
  },
};

export const flightSilence: Attack = {
  name: 'flight-silence',
  about: `${RECORDS} records, then silence for longer than the flight recorder keeps`,
  async run(environment) {
    const master = await environment.startMaster();
    await master.call({
      topic: '/services/ubii/flight_recorder_set',
      flightRecorderSettings: { isOn: true, minutes: FLIGHT_MS / 60_000 },
    });
    const client = createClient({ url: master.endpoints.url, name: 'talker' });
    await client.connect();
    environment.closeLater(() => client.close());
    for (let index = 0; index < RECORDS; index++) {
      client.publish('/said', 'double', index, { immediate: true });
    }
    await pause(1_000);
    const heldAtFirst = await held();
    await pause(2 * FLIGHT_MS);
    const heldLater = await held();
    const { recording } = await master.call({
      topic: '/services/ubii/flight_recorder_keep',
      flightRecorderKeepRequest: { name: 'kept' },
    });
    return [
      comparison('records held at first', String(heldAtFirst)),
      finding('records held when their time is over', String(heldLater), '0', heldLater === 0),
      finding(
        'records in what is kept then',
        String(recording!.recordCount),
        'the last value alone',
        recording!.recordCount <= 1,
      ),
    ];

    async function held(): Promise<number> {
      const { flightRecorder } = await master.call({
        topic: '/services/ubii/flight_recorder_get',
      });
      return flightRecorder!.recordCount;
    }
  },
};

export const deletedIds: Attack = {
  name: 'deleted-ids',
  about: 'requests for a recording that was deleted',
  async run(environment) {
    const master = await environment.startMaster();
    const id = await startRecording(master, 'short');
    await master.call({ topic: '/services/ubii/recording_stop', recordingRequest: { id } });
    await master.call({ topic: '/services/ubii/recording_delete', recordingRequest: { id } });
    const requests: readonly Init<ServiceRequest>[] = [
      {
        topic: '/services/ubii/recording_change',
        recordingChangeRequest: { id, name: 'again', notes: '' },
      },
      { topic: '/services/ubii/recording_mark', recordingMarker: { recordingId: id, text: 'a' } },
      { topic: '/services/ubii/recording_get', recordingRequest: { id } },
      { topic: '/services/ubii/recording_stop', recordingRequest: { id } },
      { topic: '/services/ubii/recording_delete', recordingRequest: { id } },
      { topic: '/services/ubii/recording_upload', recordingRequest: { id } },
      { topic: '/services/ubii/replay_start', replayStartRequest: { recordingId: id } },
    ];
    const findings: Finding[] = [];
    for (const request of requests) {
      const code = (await master.ask(request)).error?.code ?? 'done';
      const name = request.topic!.replace('/services/ubii/', '');
      findings.push(finding(name, code, 'not_found', code === 'not_found'));
    }
    const { status } = await environment.insider(master).ask('GET', `/recordings/${id}.mcap`);
    const { failures } = master;
    return [
      ...findings,
      finding('download', String(status), '404', status === 404),
      finding('errors in the log', String(failures.length), '0', failures.length === 0),
    ];
  },
};

function mode(what: string, path: string, wanted: number): Finding {
  const has = existsSync(path) ? statSync(path).mode & 0o777 : 0;
  const text = (value: number): string => `0${value.toString(8)}`;
  return finding(`mode of ${what}`, text(has), text(wanted), has === wanted);
}

/** What a program of another user reads, where this process may be one. */
function whatOthersRead(folder: string): Finding[] {
  if (process.getuid?.() !== 0) return [];
  const files = readdirSync(folder).filter((name) => name.endsWith('.mcap'));
  const read = files.filter((name) => {
    const user = { uid: NOBODY, gid: NOBODY };
    return spawnSync('head', ['-c', '8', join(folder, name)], user).stdout?.length === 8;
  });
  const figure = `${read.length} of ${files.length}`;
  return [finding('recordings that another user reads', figure, 'none', read.length === 0)];
}

function yes(isSo: boolean): string {
  return isSo ? 'yes' : 'no';
}
