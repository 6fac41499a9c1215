import { encode, type ProcessingModule, type Session } from '@ubii/proto';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { StoredMessages } from './stored-messages.ts';

/** @throws ServiceError when there is no room to store this message. */
export function requireRoom<T extends 'ubii.sessions.Session' | 'ubii.processing.ProcessingModule'>(
  limitWatch: LimitWatch,
  stored: StoredMessages<T>,
  type: T,
  message: T extends 'ubii.sessions.Session' ? Session : ProcessingModule,
): void {
  const { storedDocuments, storedBytes, sessionBytes } = limitWatch.limits;
  const what = type === 'ubii.sessions.Session' ? 'sessions' : 'modules';
  if (stored.get(message.name) === undefined && stored.list().size >= storedDocuments) {
    throw limitWatch.refusal('storedDocuments', `more than ${storedDocuments} stored ${what}`);
  }
  const { byteLength } = encode<'ubii.sessions.Session' | 'ubii.processing.ProcessingModule'>(
    type,
    message,
  );
  if (byteLength > sessionBytes) {
    throw limitWatch.refusal(
      'sessionBytes',
      `more than ${sessionBytes} bytes of one of the ${what}`,
    );
  }
  if (stored.bytesBeside(message.name) + byteLength > storedBytes) {
    throw limitWatch.refusal('storedBytes', `more than ${storedBytes} bytes of stored ${what}`);
  }
}
