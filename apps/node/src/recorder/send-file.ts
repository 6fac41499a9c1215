import { createReadStream } from 'node:fs';
import { stat } from 'node:fs/promises';
import { request as requestHttp, type IncomingMessage } from 'node:http';
import { request as requestHttps } from 'node:https';
import { pipeline } from 'node:stream/promises';
import { fromJson, ServiceError } from '@ubii/proto';

/** A file to send to the master. */
export interface FileToSend {
  readonly path: string;
  readonly recordingId: string;
  readonly clientId: string;
  /** URL of the master. */
  readonly master: string;
  /** Shows who sends it; undefined when the master asks for nothing. [AC-13] */
  readonly credential: string | undefined;
  readonly signal: AbortSignal;
  onProgress(bytes: number): void;
}

/** A reply is a recording or an error. */
const MAX_REPLY_BYTES = 1024 * 1024;

/**
 * Uploads the file of a recording. [RC-63]
 *
 * @throws ServiceError when the master refuses it; the error of the file or of the connection
 */
export async function sendFile(file: FileToSend): Promise<void> {
  const { size } = await stat(file.path);
  const url = new URL('/recordings', file.master);
  url.searchParams.set('recording', file.recordingId);
  url.searchParams.set('client', file.clientId);
  const send = url.protocol === 'https:' ? requestHttps : requestHttp;
  const headers: Record<string, string | number> = {
    'content-type': 'application/octet-stream',
    'content-length': size,
  };
  if (file.credential !== undefined) headers['authorization'] = `Bearer ${file.credential}`;
  const request = send(url, { method: 'POST', headers, signal: file.signal });
  const replied = new Promise<IncomingMessage>((resolve, reject) => {
    request.on('response', resolve);
    request.on('error', reject);
  });
  let sent = 0;
  const content = createReadStream(file.path);
  content.on('data', (part) => file.onProgress((sent += part.length)));
  // The master may answer, and close, before it has read everything: its answer says more than the broken pipe.
  const piped = pipeline(content, request).catch((cause: unknown) => cause);
  const response = await replied.catch(async (cause: unknown) => {
    await piped;
    throw cause;
  });
  const text = await textOf(response);
  if (response.statusCode === 200) return;
  content.destroy();
  throw refusalOf(text, response.statusCode ?? 0);
}

async function textOf(response: IncomingMessage): Promise<string> {
  response.setEncoding('utf8');
  let text = '';
  for await (const part of response) {
    text += String(part);
    if (text.length > MAX_REPLY_BYTES) throw new Error('The reply of the master is too long');
  }
  return text;
}

function refusalOf(text: string, status: number): Error {
  try {
    const { error } = fromJson('ubii.services.ServiceReply', JSON.parse(text) as object);
    if (error !== undefined) return ServiceError.fromWire(error);
  } catch {
    // No reply of a master of ours.
  }
  return new Error(`The master answered with status ${status}`);
}
