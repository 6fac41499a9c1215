import { ServiceError } from '@ubii/proto';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { ConnectionError } from './connection-error.ts';
import { explainConnectionError } from './explain-connection-error.ts';

afterEach(() => vi.unstubAllGlobals());

describe('explainConnectionError()', () => {
  it.each([
    ['missing', 'Set joinToken'],
    ['wrong', 'Check joinToken'],
    ['expired', 'Ask an admin of the master for a new one.'],
    ['revoked', 'Ask an admin of the master for a new one.'],
    ['used', 'Ask an admin of the master for a new one.'],
    ['guessing', 'Wait some seconds'],
  ] as const)('says what to do about a code that is %s', (joinProblem, remedy) => {
    const error = new ConnectionError('join', 'Scan the QR code.', { joinProblem });
    expect(explainConnectionError(error)).toContain(remedy);
    expect(explainConnectionError(error)).not.toContain('QR');
  });

  it('says what to do about an address', () => {
    const error = new ConnectionError('refused', 'The master cannot be reached at http://m');
    expect(explainConnectionError(error)).toBe(
      'The master cannot be reached at http://m. Check the address, and that a master runs there.',
    );
    const other = new ConnectionError('protocol', 'Expected a service reply from http://m');
    expect(explainConnectionError(other)).toContain('/sdk/');
  });

  it('tells a page of a file that it needs a token [AC-46]', () => {
    vi.stubGlobal('origin', 'null');
    const error = new ConnectionError('refused', 'The master cannot be reached at http://m');
    expect(explainConnectionError(error)).toContain('needs a token as joinToken');
  });

  it('keeps what the master said', () => {
    const cause = new ServiceError('invalid_argument', 'The name is too long.');
    const error = new ConnectionError('refused', 'The name is too long.', { cause });
    expect(explainConnectionError(error)).toBe('The name is too long.');
    const role = new ConnectionError('join', 'Viewers may not do this.', { joinProblem: 'role' });
    expect(explainConnectionError(role)).toBe('Viewers may not do this.');
  });

  it('names the other program of the same identity', () => {
    const error = new ConnectionError('superseded', 'The master closed the connection');
    expect(explainConnectionError(error)).toContain('End one of them');
  });
});
