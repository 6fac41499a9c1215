import { afterAll, afterEach, describe, expect, it, vi } from 'vitest';
import { createConsoleErrors } from './console-errors.ts';

describe('createConsoleErrors()', () => {
  const write = vi.spyOn(console, 'error').mockImplementation(() => undefined);
  afterEach(() => write.mockClear());
  afterAll(() => write.mockRestore());

  it('writes where an error comes from, with its stack', () => {
    const error = new RangeError('too large');
    createConsoleErrors()(error, 'identity-storage');
    expect(write).toHaveBeenCalledExactlyOnceWith(
      'Ubi-Interact client: error in the identity storage of this program:',
      error,
    );
  });

  it('writes equal errors once, and others of the same place', () => {
    const report = createConsoleErrors();
    for (const message of ['a', 'a', 'b']) report(new Error(message), 'listener');
    report(new Error('a'), 'identity-storage');
    report('a', 'listener');
    report('b', 'listener');
    expect(write).toHaveBeenCalledTimes(4);
  });

  it('stops after 100 errors, as messages may all differ', () => {
    const report = createConsoleErrors();
    for (let i = 0; i < 200; i++) report(new Error(`${i}`), 'listener');
    expect(write).toHaveBeenCalledTimes(100);
  });
});
