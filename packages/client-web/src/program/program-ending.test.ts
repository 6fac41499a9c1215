import { describe, expect, it } from 'vitest';
import { ConnectionError } from '../core/connection/connection-error.ts';
import type { ConnectionErrorReason } from '../core/connection/connection-error.ts';
import { endingOf, versionNotice } from './program-ending.ts';

describe('the ending of a program', () => {
  it.each([
    ['refused', 3],
    ['timeout', 3],
    ['join', 4],
    ['protocol', 5],
    ['superseded', 6],
    ['disconnected', 7],
  ] satisfies [ConnectionErrorReason, number][])('after %s has exit code %i', (reason, code) => {
    const { message, exitCode } = endingOf(new ConnectionError(reason, 'It failed'))!;
    expect(exitCode).toBe(code);
    expect(message).toMatch(/\.$/);
    expect(message).not.toContain('\n');
  });

  it('after wrong options has exit code 2', () => {
    expect(endingOf(new TypeError('No URL'))).toEqual({ message: 'No URL.', exitCode: 2 });
  });

  it('is not known for other errors', () => {
    expect(endingOf(new Error('of the program'))).toBeUndefined();
  });
});

describe('versionNotice()', () => {
  it.each([
    ['0.1.7', '0.1.0'],
    ['2.4.0', '2.1.9'],
    [undefined, '0.1.0'],
  ])('accepts a master of version %s with the library %s', (master, library) => {
    expect(versionNotice(master, 'http://m', library)).toBeUndefined();
  });

  it.each([
    ['0.2.0', '0.1.0'],
    ['1.0.0', '0.1.0'],
    ['3.0.0', '2.9.0'],
  ])('says how to install the library of a master of version %s, with %s', (master, library) => {
    expect(versionNotice(master, 'http://m', library)).toContain(
      `npm i http://m/sdk/ubii-client-${master}.tgz`,
    );
  });
});
