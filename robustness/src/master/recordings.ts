import { encodeRecord, fromJson, type JsonObject, type Recording } from '@ubii/proto';
import type { RecordedRecord, RecordingEvent } from '@ubii/recording';
import { recorded } from '@ubii/recording/testing';

import type { MasterProcess } from './master-process.ts';
import type { Outsider } from './outsider.ts';

/** Path of the file of a recording at a master. */
export function recordingFilePath(id: string): string {
  return `/recordings/${id}.mcap`;
}

/** Result of an upload. */
export interface UploadAnswer {
  /** 0: the master closed the connection without an answer. */
  readonly status: number;
  /** Undefined when the upload was refused. */
  readonly recording: Recording | undefined;
  /** Sentence of the refusal; empty when there is none. */
  readonly refusal: string;
}

/** Uploads a file as a recording. @param query such as `?name=a` */
export async function uploadRecording(
  caller: Outsider,
  file: Uint8Array,
  { bearer, query = '' }: { readonly bearer?: string | undefined; readonly query?: string } = {},
): Promise<UploadAnswer> {
  const headers = {
    'content-type': 'application/octet-stream',
    ...(bearer !== undefined && { authorization: `Bearer ${bearer}` }),
  };
  const { status, body } = await caller.ask('POST', `/recordings${query}`, headers, file);
  return readUploadAnswer(status, body);
}

/** Reads the reply to an upload. */
export function readUploadAnswer(status: number, body: Uint8Array): UploadAnswer {
  const text = Buffer.from(body).toString();
  if (status === 200) {
    const json = JSON.parse(text) as JsonObject;
    return { status, recording: fromJson('ubii.extension.Recording', json), refusal: '' };
  }
  return { status, recording: undefined, refusal: text };
}

/** Records everything until `stop` is called. @returns the id of the recording */
export async function startRecording(master: MasterProcess, name: string): Promise<string> {
  const { recording } = await master.call({
    topic: '/services/ubii/recording_start',
    recordingStartRequest: { name },
  });
  return recording!.id;
}

/** A record of a number. @param atMs milliseconds since the Unix epoch */
export function numberRecord(topic: string, value: number, atMs: number): RecordedRecord {
  const logTimeNs = BigInt(Math.round(atMs)) * 1_000_000n;
  const record = encodeRecord({ topic, format: 'double', value });
  return { topic, clientId: 'recorded', record, logTimeNs, publishTimeNs: logTimeNs };
}

/** The file of a recording with numbers of one topic, 100 a second. */
export async function recordingFile(
  topic: string,
  count: number,
  events: readonly RecordingEvent[] = [],
): Promise<Uint8Array> {
  const startMs = Date.now() - 3_600_000;
  const records = Array.from({ length: count }, (_, index) =>
    numberRecord(topic, index, startMs + index * 10),
  );
  return (await recorded(records, events)).bytes;
}
