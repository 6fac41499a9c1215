import { encodeErrorFrame } from '@ubii/proto/wire';
import type { ErrorMessage } from '@ubii/proto';

import type { FrameParts } from '../output/joined-parts.ts';
import {
  recordListEncoder,
  singleRecordEncoder,
  type MessageHead,
} from '../output/topic-data-encoders.ts';
import { DELIMITER, encodeFrame, frameHeaderSize, writeFrameHeader } from './zmtp-frames.ts';

/*
 * Messages from a ROUTER to a DEALER, as existing clients expect them: an empty frame, then the content. [TD-50]
 */

const HEAD: MessageHead = {
  size: (contentBytes) => DELIMITER.length + frameHeaderSize(contentBytes),
  write(target, start, contentBytes) {
    target.set(DELIMITER, start);
    return writeFrameHeader(target, start + DELIMITER.length, contentBytes);
  },
};

export const singleMessages = singleRecordEncoder(HEAD);
export const listMessages = recordListEncoder(HEAD);

/** A message with an encoded `TopicData`. */
export function topicDataMessage(content: Uint8Array): FrameParts {
  return [DELIMITER, encodeFrame(content)];
}

/** A message with an error. [TD-17] */
export function errorMessage(error: ErrorMessage): FrameParts {
  return topicDataMessage(encodeErrorFrame(error));
}

/** A message with a heartbeat. @param text ASCII */
export function textMessage(text: string): FrameParts {
  return topicDataMessage(Buffer.from(text, 'latin1'));
}
