import type { Socket } from 'node:net';
import { type MasterProcess, mib } from '@ubii/harness';
import { AccessRole, type Init, type ServiceRequest } from '@ubii/proto';
import {
  attachmentIndexOf3Gib,
  lz4Bomb,
  manyMarkers,
  manyMarkersWithoutEnd,
  markerChunkIndexOf3Gib,
  metadataIndexOf3Gib,
  recordChunkIndexOf3Gib,
  sampleRecord,
} from '@ubii/recording/testing';

import {
  malformedEvent,
  MALFORMED_EVENTS,
  MARKER,
  recordingWith,
  uploadRecording,
} from '../../fixtures/recordings.ts';
import { pause } from '../../pause.ts';
import { comparison, finding, type Attack, type Finding } from '../attack.ts';
import { tryUpload, type HostileFile } from '../parts/try-upload.ts';
import type { AttackEnvironment } from '../environment/attack-environment.ts';

const MAX_REPLY_BYTES = 1024 * 1024;
const LONG_TEXT = 180_000_000;
const SHORT_TEXT = 1_000_000;
const UPLOADS = 60;
/** The limit `uploadsPerClient`. */
const MAX_UPLOADS = 2;

export const uploadLengths: Attack = {
  name: 'upload-lengths',
  about: 'uploads of some hundred bytes whose index states 3 GiB',
  run: (environment) => tryEach(environment, LENGTHS),
};

export const uploadWeight: Attack = {
  name: 'upload-weight',
  about: 'uploads of at most 5 MB that unpack to millions of markers, or to a gigabyte',
  run: (environment) => tryEach(environment, WEIGHTS),
};

export const uploadTexts: Attack = {
  name: 'upload-texts',
  about: 'uploads whose name and notes are long',
  run: (environment) => tryEach(environment, TEXTS),
};

export const uploadClaims: Attack = {
  name: 'upload-claims',
  about: 'uploads with malformed events, and with a study that they are no part of',
  async run(environment) {
    const master = await environment.startMaster();
    const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const caller = environment.outsider(master);
    const { bearer } = await caller.join(token);
    const findings: Finding[] = [];
    for (const [name, events] of Object.entries(MALFORMED_EVENTS)) {
      const answer = await uploadRecording(caller, await recordingWith({}, events), { bearer });
      const faults = answer.recording === undefined ? [] : await use(master, answer.recording.id);
      const isClear = answer.status === 200 || answer.status === 400;
      const figure = answer.status === 200 ? 'accepted' : String(answer.status);
      findings.push(
        finding(
          `${name}: answer, and faults of its use`,
          [figure, ...faults].join('; '),
          'accepted or 400, without faults',
          isClear && faults.length === 0,
        ),
      );
    }
    const study = { studyId: 's', studyName: 'reach', runId: 'r', participantCode: 'P01' };
    const selection = JSON.stringify({ study });
    const { recording } = await uploadRecording(caller, await recordingWith({ selection }), {
      bearer,
    });
    const claim = recording?.study?.participantCode ?? '';
    findings.push(
      finding('a study that the master does not have', claim || 'ignored', 'ignored', claim === ''),
      comparison('errors in the log', String(master.failures.length)),
    );
    return findings;
  },
};

export const uploadsAtOnce: Attack = {
  name: 'uploads-at-once',
  about: `${UPLOADS} uploads of one client at the same time`,
  async run(environment) {
    const master = await environment.startMaster();
    const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const caller = environment.outsider(master);
    const { bearer } = await caller.join(token);
    const neighbour = environment.outsider(master, 1);
    const member = await neighbour.join(token);
    const answered = new Set<Socket>();
    for (let index = 0; index < UPLOADS; index++) {
      const socket = await caller.dial();
      environment.closeLater(() => void socket.destroy());
      socket.once('data', () => answered.add(socket));
      socket.once('close', () => answered.add(socket));
      const head = caller.head('POST /recordings HTTP/1.1', {
        authorization: `Bearer ${bearer}`,
        'content-type': 'application/octet-stream',
        'content-length': '100000',
      });
      socket.write(head);
      socket.write(Buffer.alloc(1_000));
    }
    await pause(2_000);
    const taken = UPLOADS - answered.size;
    const file = await recordingWith({});
    const { status } = await uploadRecording(neighbour, file, { bearer: member.bearer });
    return [
      finding(
        'uploads that the master takes at once',
        String(taken),
        `at most ${MAX_UPLOADS}`,
        taken <= MAX_UPLOADS,
      ),
      finding('another client uploads meanwhile', String(status), '200', status === 200),
    ];
  },
};

const LENGTHS: readonly HostileFile[] = [
  { name: 'metadata index', make: metadataIndexOf3Gib },
  { name: 'chunk index of markers', make: markerChunkIndexOf3Gib },
  { name: 'chunk index of records', make: recordChunkIndexOf3Gib },
  { name: 'index of a snapshot', make: attachmentIndexOf3Gib },
];

const WEIGHTS: readonly HostileFile[] = [
  { name: 'five million markers', make: () => manyMarkers() },
  { name: 'five million markers, no end', make: () => manyMarkersWithoutEnd() },
  { name: '600,000 markers in 61 MB', make: () => manyMarkers(600_000) },
  { name: 'an LZ4 bomb', make: () => lz4Bomb() },
];

const TEXTS: readonly HostileFile[] = [
  { name: 'name and notes of 1 MB', make: () => withTexts(SHORT_TEXT), look: readReplies },
  { name: 'name and notes of 180 MB', make: () => withTexts(LONG_TEXT), look: readReplies },
  { name: '5000 topics, 9000 markers', make: manyTopics, look: readReplies },
];

async function tryEach(
  environment: AttackEnvironment,
  files: readonly HostileFile[],
): Promise<readonly Finding[]> {
  const findings: Finding[] = [];
  for (const file of files) {
    findings.push(...(await tryUpload(environment, file)));
    await environment.clear();
  }
  return findings;
}

function withTexts(length: number): Promise<Uint8Array> {
  return recordingWith({ name: 'n'.repeat(length), notes: 'm'.repeat(length) });
}

function manyTopics(): Promise<Uint8Array> {
  const markers = Array.from({ length: 9_000 }, (_, index) =>
    malformedEvent('marker', { ...MARKER, id: `m${index}`, text: 't'.repeat(500) }),
  );
  const records = Array.from({ length: 5_000 }, (_, index) =>
    sampleRecord(`/${'topic/'.repeat(20)}${index}`, index),
  );
  return recordingWith({}, markers, records);
}

/** The size of the replies about a recording. */
async function readReplies(master: MasterProcess, id: string): Promise<readonly Finding[]> {
  const sizeOf = async (request: object): Promise<number> => {
    const response = await fetch(master.endpoints.servicesJson, {
      method: 'POST',
      headers: { 'content-type': 'application/json' },
      body: JSON.stringify(request),
    });
    return (await response.arrayBuffer()).byteLength;
  };
  const replies = [
    ['recording_list', { topic: '/services/ubii/recording_list' }],
    ['recording_get', { topic: '/services/ubii/recording_get', recordingRequest: { id } }],
  ] as const;
  const findings: Finding[] = [];
  for (const [name, request] of replies) {
    const bytes = await sizeOf(request);
    const aim = `at most ${mib(MAX_REPLY_BYTES)}`;
    findings.push(finding(`a reply of ${name}`, mib(bytes), aim, bytes <= MAX_REPLY_BYTES));
  }
  return findings;
}

/** Uses a recording as pages do. @returns what went wrong */
async function use(master: MasterProcess, id: string): Promise<string[]> {
  const requests: readonly Init<ServiceRequest>[] = [
    { topic: '/services/ubii/recording_list' },
    { topic: '/services/ubii/recording_get', recordingRequest: { id } },
    { topic: '/services/ubii/recording_mark', recordingMarker: { recordingId: id, text: 'a' } },
    {
      topic: '/services/ubii/recording_change',
      recordingChangeRequest: { id, name: 'renamed', notes: '' },
    },
    { topic: '/services/ubii/recording_get', recordingRequest: { id } },
    { topic: '/services/ubii/recording_delete', recordingRequest: { id } },
  ];
  const faults: string[] = [];
  for (const request of requests) {
    const problem = await master.ask(request).then(
      ({ error }) => error?.code,
      () => 'no reply',
    );
    if (problem) faults.push(`${request.topic?.replace('/services/ubii/', '')}: ${problem}`);
  }
  return faults;
}
