import { createWriteStream } from 'node:fs';
import { mkdir, rm } from 'node:fs/promises';
import type { IncomingMessage } from 'node:http';
import { Transform, type TransformCallback } from 'node:stream';
import { pipeline } from 'node:stream/promises';
import { ServiceError } from '@ubii/proto';

import { OWNER_FILE_MODE, OWNER_FOLDER_MODE, uploadPath } from '@ubii/recording/node';

/**
 * Writes the body of a request as the upload `id`. [RC-41]
 *
 * @param take called for each part; rejects when there is no space for it
 * @throws ServiceError when it is too large, ends early or cannot be written; nothing is kept then [RC-42]
 */
export async function receiveUpload(
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
