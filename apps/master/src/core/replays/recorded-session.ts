import { decode, encode, fromJson, ServiceError, type JsonObject, type Session } from '@ubii/proto';
import type { RecordedSession } from '@ubii/recording';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { boundTexts } from '../texts/bound-texts.ts';

/**
 * The session of a file as a request could hold it: files may be from other masters, or from unknown programs.
 *
 * @throws ServiceError when it is no session, or has a text that is too long [RC-54] [RC-55]
 */
export function recordedSession({ session }: RecordedSession, watch: LimitWatch): Session {
  const type = 'ubii.services.ServiceRequest';
  const request = decode(type, encode(type, { session: parse(session) }));
  const bounded = boundTexts(type, request, {
    limits: watch.limits,
    refuse: ({ limit, length }) =>
      watch.refusal(limit, `a text of length ${length} of the recorded session`),
  });
  return bounded.session!;
}

function parse(json: string): Session {
  try {
    return fromJson('ubii.sessions.Session', JSON.parse(json) as JsonObject);
  } catch (cause) {
    throw new ServiceError(
      'failed_precondition',
      'The recorded session cannot be read. Choose another one, or play topics alone.',
      { cause },
    );
  }
}
