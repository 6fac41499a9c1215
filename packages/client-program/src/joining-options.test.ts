import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { readOptions } from '@ubii/program';
import { temporaryFolder } from '@ubii/program/testing';
import { expect, it } from 'vitest';

import { checkJoining, JOINING_OPTIONS, readTokenFile } from './joining-options.ts';

function fileWith(text: string): string {
  const file = join(temporaryFolder(), 'admin-token');
  writeFileSync(file, text);
  return file;
}

it('reads the token, without the line break [AC-44]', () => {
  expect(readTokenFile(fileWith('abc-123\n'))).toBe('abc-123');
  expect(readTokenFile(fileWith('http://localhost:8080/join#abc-123'))).toBe('abc-123');
});

it('throws an error with the reason for an invalid file', () => {
  expect(() => readTokenFile('/nowhere/admin-token')).toThrow('it does not exist');
  expect(() => readTokenFile(fileWith(''))).toThrow('must contain a token or code');
  expect(() => readTokenFile(fileWith('a\nb'))).toThrow('must contain a token or code');
});

it('replaces a token on the command line', () => {
  const program = {
    options: JOINING_OPTIONS,
    environmentPrefix: 'UBII_NODE_',
    about: '',
    check: checkJoining,
  };
  const read = (args: string[], env = {}) =>
    readOptions(program, args, env, '/folder').values.tokenFile;
  expect(read(['--token-file', 'a'])).toBe('/folder/a');
  expect(read([], { UBII_NODE_TOKEN_FILE: '/b' })).toBe('/b');
  expect(() => read(['--token-file', 'a', '--join', 'K7QF-2MXR'])).toThrow('Remove one of them');
});
