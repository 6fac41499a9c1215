import { readdirSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it } from 'vitest';

import { readOrCreateTokenKey } from './token-key-file.ts';

describe('[EX-3] the key of the resume tokens', () => {
  it('is made once and stays', () => {
    const dataDir = temporaryFolder();
    const key = readOrCreateTokenKey(dataDir);
    expect(key).toHaveLength(32);
    expect(readOrCreateTokenKey(dataDir)).toEqual(key);
    expect(readOrCreateTokenKey(temporaryFolder())).not.toEqual(key);
  });

  it.skipIf(process.platform === 'win32')(
    'is readable by its owner only, and leaves no draft',
    () => {
      const dataDir = temporaryFolder();
      readOrCreateTokenKey(dataDir);
      expect(readdirSync(dataDir)).toEqual(['resume-token.key']);
      expect(statSync(join(dataDir, 'resume-token.key')).mode & 0o777).toBe(0o600);
    },
  );

  it('is never guessed from a damaged file', () => {
    const dataDir = temporaryFolder();
    writeFileSync(join(dataDir, 'resume-token.key'), 'short');
    expect(() => readOrCreateTokenKey(dataDir)).toThrow(/must hold 32 bytes .* Delete it/);
  });
});
