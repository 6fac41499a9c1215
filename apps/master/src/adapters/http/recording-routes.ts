import { createWriteStream, createReadStream } from 'node:fs';
import { mkdir, rm, stat } from 'node:fs/promises';
import type { IncomingMessage } from 'node:http';
import { Transform, type TransformCallback } from 'node:stream';
import { pipeline } from 'node:stream/promises';
import { randomUUID } from 'node:crypto';
import { ServiceError, RecordingState, toJson } from '@ubii/proto';
import {
  OWNER_FILE_MODE,
  OWNER_FOLDER_MODE,
  uploadPath,
  recordingPath,
} from '@ubii/recording/node';
import type { FastifyInstance, FastifyReply, FastifyRequest } from 'fastify';
import type { Limits } from '../../core/limits/index.ts';
import { quote } from '../../core/texts/quote.ts';
import type { Master } from '../../core/master/master.ts';
import type { CallerReader } from '../access/caller-reader.ts';

/** Part of a file. */
interface ByteRange {
  /** First and last byte, from 0. */
  readonly start: number;
  readonly end: number;
}

/**
 * Reads a `Range` header with one range of bytes (RFC 9110, section 14.2).
 *
 * @returns undefined when the whole file is to be sent: without a header, and for all that is no single range of bytes;
 *   `unsatisfiable` when it begins behind the end
 */
function parseByteRange(
  header: string | undefined,
  size: number,
): ByteRange | 'unsatisfiable' | undefined {
  const [, first, last] = /^bytes=(\d{0,15})-(\d{0,15})$/.exec(header?.trim() ?? '') ?? [];
  if (first === undefined || last === undefined || first + last === '') return undefined;
  const start = first === '' ? Math.max(0, size - Number(last)) : Number(first);
  const end = first === '' || last === '' ? size - 1 : Math.min(Number(last), size - 1);
  if (last !== '' && first !== '' && Number(last) < start) return undefined;
  return start < size && start <= end ? { start, end } : 'unsatisfiable';
}

/**
 * Writes the body of a request as the upload `id`. [RC-41]
 *
 * @param take called for each part; rejects when there is no space for it
 * @throws ServiceError when it is too large, ends early or cannot be written; nothing is kept then [RC-42]
 */
async function receiveUpload(
  body: IncomingMessage,
  { folder, id }: { readonly folder: string; readonly id: string },
  take: (bytes: number) => Promise<void>,
): Promise<void> {
  const path = uploadPath(folder, id);
  try {
    await mkdir(folder, { recursive: true, mode: OWNER_FOLDER_MODE });
    const file = createWriteStream(path, { flags: 'wx', mode: OWNER_FILE_MODE });
    await pipeline(body, taken(take), file);
  } catch (cause) {
    await rm(path, { force: true });
    if (cause instanceof ServiceError) throw cause;
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new ServiceError(
      'failed_precondition',
      `The upload could not be kept: ${reason}. Send it again.`,
    );
  }
}

/** Passes on parts that may be taken. */
function taken(take: (bytes: number) => Promise<void>): Transform {
  return new Transform({
    transform(chunk: Buffer, _encoding: BufferEncoding, done: TransformCallback): void {
      take(chunk.length).then(() => done(null, chunk), done);
    },
  });
}

export interface RecordingRoutesContext {
  readonly master: Pick<Master, 'requireRecording' | 'uploadRecording' | 'uploadNodeRecording'>;
  readonly callers: Pick<CallerReader, 'read'>;
  readonly recordingsFolder: string;
  readonly limits: Pick<Limits, 'nameCharacters'>;
}

/** Files of recordings: to download, in ranges as well, and to upload. [RC-40] [RC-41] */
export function addRecordings(app: FastifyInstance, context: RecordingRoutesContext): void {
  app.get('/recordings/:id.mcap', (request, reply) => sendFile(request, reply, context));
  app.post('/recordings', async (request, reply) => {
    const recording = await takeFile(request, context);
    return reply
      .header('cache-control', 'no-store')
      .type('application/json; charset=utf-8')
      .send(JSON.stringify(toJson('ubii.extension.Recording', recording)));
  });
}

async function sendFile(
  { params, headers, raw }: FastifyRequest,
  reply: FastifyReply,
  { master, callers, recordingsFolder }: RecordingRoutesContext,
): Promise<FastifyReply> {
  const { id } = params as { readonly id: string };
  const recording = await master.requireRecording(id, callers.read(raw));
  const { name, state, nodeName, problem } = recording;
  if (state === RecordingState.RECORDING_STATE_RECORDING) {
    throw new ServiceError(
      'failed_precondition',
      'This recording is running. Stop it before you download its file.',
    );
  }
  if (state === RecordingState.RECORDING_STATE_AT_NODE) {
    throw new ServiceError(
      'failed_precondition',
      `The file of this recording is still on the node ${quote(nodeName)}. It can be downloaded when it is uploaded.`,
    );
  }
  if (state === RecordingState.RECORDING_STATE_REJECTED) {
    throw new ServiceError('failed_precondition', `${problem} It can only be deleted.`);
  }
  const path = recordingPath(recordingsFolder, id);
  const { size, mtimeMs } = await stat(path);
  const etag = `"${size.toString(16)}-${Math.round(mtimeMs * 1000).toString(16)}"`;
  reply
    .header('etag', etag)
    .header('accept-ranges', 'bytes')
    .header('cache-control', 'no-cache')
    .header('x-content-type-options', 'nosniff')
    .header('content-security-policy', "default-src 'none'")
    .header('content-disposition', `attachment; filename*=UTF-8''${encodeURIComponent(name)}.mcap`)
    .type('application/octet-stream');
  if (headers['if-none-match'] === etag) return reply.code(304).send();
  // A part of another version would not fit to what the caller has (RFC 9110, section 13.1.5).
  const isOther = headers['if-range'] !== undefined && headers['if-range'] !== etag;
  const range = isOther ? undefined : parseByteRange(headers.range, size);
  if (range === 'unsatisfiable') {
    return reply.code(416).header('content-range', `bytes */${size}`).send();
  }
  if (range === undefined) {
    return reply.header('content-length', size).send(createReadStream(path));
  }
  const { start, end } = range;
  return reply
    .code(206)
    .header('content-range', `bytes ${start}-${end}/${size}`)
    .header('content-length', end - start + 1)
    .send(createReadStream(path, range));
}

async function takeFile(
  { raw, query }: FastifyRequest,
  { master, callers, recordingsFolder, limits }: RecordingRoutesContext,
): ReturnType<Master['uploadRecording']> {
  const text = (member: string): string => {
    const value = (query as Readonly<Record<string, unknown>>)[member] ?? '';
    if (typeof value === 'string' && value.length <= limits.nameCharacters) return value;
    throw new ServiceError(
      'invalid_argument',
      `The query ${member} is one text of at most ${limits.nameCharacters} characters.`,
    );
  };
  const [name, recordingId, clientId] = ['name', 'recording', 'client'].map(text);
  const id = recordingId || randomUUID();
  const upload = {
    declaredBytes: Number(raw.headers['content-length'] ?? 0),
    receive: (take: (bytes: number) => Promise<void>) =>
      receiveUpload(raw, { folder: recordingsFolder, id }, take),
  };
  const caller = callers.read(raw);
  return recordingId
    ? master.uploadNodeRecording({ ...upload, recordingId, clientId: clientId! }, caller)
    : master.uploadRecording(
        { ...upload, id, isAwaited: () => !raw.socket.destroyed },
        name!,
        caller,
      );
}
