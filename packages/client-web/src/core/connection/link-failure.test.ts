import { ServiceError } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { ConnectionError } from './connection-error.ts';
import { failureOf, failureOfClose, isTold, remedyFor } from './link-failure.ts';

describe('remedyFor() [EX-5]', () => {
  it.each([
    [4001, 'stop'],
    [4003, 'register-as-new'],
    [4004, 'register-again'],
    [4010, 'stop'],
    [1000, 'register-again'],
    [1001, 'retry'],
    [1006, 'retry'],
    [1009, 'retry'],
    [4008, 'retry'],
    [4009, 'retry'],
    [4013, 'retry'],
    [4999, 'retry'],
  ])('answers close code %i with %s', (code, remedy) => {
    const failure = failureOfClose(code, '', true);
    expect(remedyFor(failure)).toBe(remedy);
    expect(isTold(failure)).toBe(remedy !== 'retry');
  });

  it.each([
    ['invalid_argument', 'stop'],
    ['permission_denied', 'stop'],
    ['unauthenticated', 'stop'],
    ['unimplemented', 'stop'],
    ['not_found', 'register-again'],
    ['resource_exhausted', 'retry'],
    ['unavailable', 'retry'],
    ['deadline_exceeded', 'retry'],
    ['internal', 'retry'],
  ] as const)('answers a registration refused with %s with %s', (code, remedy) => {
    const failure = failureOf(new ServiceError(code, 'why'));
    expect(failure.error).toMatchObject({ reason: 'refused' });
    expect(failure.error.message).toContain('why');
    expect(remedyFor(failure)).toBe(remedy);
  });

  it('registers again after a socket opened without an answer on it', () => {
    const error = new ConnectionError('timeout', 'silence');
    expect(remedyFor({ error, code: 1006, wasUp: false })).toBe('register-again');
    expect(remedyFor({ error, code: 1006, wasUp: true })).toBe('retry');
  });
});

describe('failureOfClose()', () => {
  it('repeats the reason of the master', () => {
    expect(failureOfClose(4013, 'too many', false).error.message).toBe(
      'The master closed the connection with code 4013: too many',
    );
    expect(failureOfClose(1006, '', true).error.message).toBe(
      'The connection to the master was lost',
    );
  });

  it('calls 4010 disconnected, with actor and reason [EX-30]', () => {
    const { error } = failureOfClose(4010, 'by Mara: too loud', true);
    expect(error.reason).toBe('disconnected');
    expect(error.message).toBe('This client was disconnected by Mara: too loud');
    expect(failureOfClose(4010, '', true).error.message).toBe('This client was disconnected');
  });

  it('calls 4001 superseded', () => {
    expect(failureOfClose(4001, '', true).error.reason).toBe('superseded');
  });
});
