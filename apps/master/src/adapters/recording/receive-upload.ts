import { createWriteStream } from 'node:fs';
import { mkdir, rm } from 'node:fs/promises';
import type { IncomingMessage } from 'node:http';
import { Transform, type TransformCallback } from 'node:stream';
import { pipeline } from 'node:stream/promises';
import { ServiceError } from '@ubii/proto';

import { uploadPath } from './disk-folder.ts';

export interface UploadParts {
  readonly folder: string;
  readonly id: string;
  /** `Content-Length`; 0 when unknown. */
  readonly declared: number;
  readonly maxBytes: number;
}

/**
 * Writes the body of a request as the upload `id`. [RC-41]
 *
 * @throws ServiceError when it is too large, ends early or cannot be written; nothing is kept then [RC-42]
 */
export async function receiveUpload(
  body: IncomingMessage,
  { folder, id, declared, maxBytes }: UploadParts,
): Promise<void> {
  if (declared > maxBytes) throw tooLarge(maxBytes);
  const path = uploadPath(folder, id);
  try {
    await mkdir(folder, { recursive: true });
    await pipeline(body, bounded(maxBytes), createWriteStream(path, { flags: 'wx' }));
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

/** Passes on bytes, and fails when there are too many. */
function bounded(maxBytes: number): Transform {
  let bytes = 0;
  return new Transform({
    transform(chunk: Buffer, _encoding: BufferEncoding, done: TransformCallback): void {
      bytes += chunk.length;
      if (bytes > maxBytes) done(tooLarge(maxBytes));
      else done(null, chunk);
    },
  });
}

function tooLarge(maxBytes: number): ServiceError {
  return new ServiceError(
    'resource_exhausted',
    `The upload has more than ${maxBytes} bytes, which is the limit recordingUploadBytes of this master.`,
    { details: { limit: 'recordingUploadBytes', max: maxBytes } },
  );
}
