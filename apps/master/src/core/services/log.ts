import { ServiceError } from '@ubii/proto';
import type { ServiceHandler } from './handler.ts';

/** `/services/ubii/log_tail` [EX-37] */
export const tailLog: ServiceHandler = ({ logTail }, request) => {
  const { cursor, level, count } = request.logRequest!;
  if (count < 0) {
    throw new ServiceError(
      'invalid_argument',
      `The member count is ${count}, but it is a number of lines, or 0 for all that are kept.`,
    );
  }
  return { logTail: logTail.read(cursor, level, count) };
};
