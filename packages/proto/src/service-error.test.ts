import { describe, expect, it } from 'vitest';
import { decode, encode } from './codec.ts';
import { DecodeError } from './decode-error.ts';
import { JoinProblem } from './generated/messages.ts';
import { SERVICE_ERROR_CODES, ServiceError } from './service-error.ts';

describe('ServiceError', () => {
  it.each(SERVICE_ERROR_CODES)('%s crosses the wire', (code) => {
    const error = new ServiceError(code, 'The topic is empty; give one.', { details: { a: 1 } });
    expect(error.toWire()).toEqual({
      title: expect.stringMatching(/^[A-Z]/) as string,
      message: 'The topic is empty; give one.',
      stack: '',
      problems: [],
      code,
    });
    const received = ServiceError.fromWire(error.toWire());
    expect(received).toMatchObject({ code, title: error.title, message: error.message });
    expect(received.details).toEqual({});
  });

  it('[EX-24] carries the problems of a session that was refused', () => {
    const problem = {
      isError: true,
      code: 'unknown_input',
      message: 'The module Mirror has no input "pos".',
      path: 'ioMappings[0].inputMappings[0].inputName',
      moduleId: '',
      moduleName: 'Mirror',
      nodeId: '',
      line: 0,
      column: 0,
    };
    const details = { problems: [problem], name: 'stays here' };
    const error = new ServiceError('invalid_argument', 'It cannot run.', { details });
    const bytes = encode('ubii.general.Error', error.toWire());
    const received = ServiceError.fromWire(decode('ubii.general.Error', bytes));
    expect(received.details).toEqual({ problems: [problem] });
  });

  it('[AC-12] contains the reason for a refused join', () => {
    const error = new ServiceError('unauthenticated', 'It was revoked.', {
      details: { joinProblem: JoinProblem.JOIN_PROBLEM_REVOKED, name: 'stays here' },
    });
    const bytes = encode('ubii.general.Error', error.toWire());
    const received = ServiceError.fromWire(decode('ubii.general.Error', bytes));
    expect(received.details).toEqual({ joinProblem: JoinProblem.JOIN_PROBLEM_REVOKED });
  });

  it('[SV-5] gives nothing away of errors that are not ours', () => {
    const cause = new Error('password is swordfish');
    const error = ServiceError.from(cause);
    expect(error.code).toBe('internal');
    expect(JSON.stringify(error.toWire())).not.toContain('swordfish');
    expect(error.cause).toBe(cause);
  });

  it('[SV-7] makes invalid_argument of what cannot be decoded, with the reason', () => {
    const error = ServiceError.from(new DecodeError('ubii.clients.Client', 0, 'it must be x'));
    expect(error.code).toBe('invalid_argument');
    expect(error.message).toBe('input cannot be read as ubii.clients.Client: it must be x.');
  });

  it('passes its own kind through', () => {
    const error = new ServiceError('not_found', 'No such client.');
    expect(ServiceError.from(error)).toBe(error);
  });

  it('reads errors of original masters, which have no code', () => {
    const wire = { title: 'SubscriptionService', message: '', stack: 'x', code: '' };
    expect(ServiceError.fromWire(wire)).toMatchObject({
      code: 'internal',
      title: 'SubscriptionService',
      message: 'SubscriptionService',
    });
    expect(ServiceError.fromWire({ title: '', message: '', stack: '', code: '' }).message).toBe(
      'The master reported no reason.',
    );
  });
});
