import { createHmac } from 'node:crypto';
import { readdirSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { temporaryFolder } from '@ubii/program/testing';
import { HmacAccessSecrets } from '../access/hmac-access-secrets.ts';
import { deriveKey, readOrCreateTokenKey } from './token-key.ts';
import { HmacResumeTokens } from './hmac-resume-tokens.ts';

const RAW = new Uint8Array(32).fill(7);
const PURPOSES = ['resume tokens', 'credentials', 'join secrets'] as const;
const hmac = (key: Uint8Array, text: string) =>
  createHmac('sha256', key).update(text).digest('base64url');

describe('keys [AC-66]', () => {
  it('are those of HKDF-SHA-256, one for each purpose', () => {
    // Extract and expand by hand (RFC 5869, 2.2 and 2.3).
    const extracted = createHmac('sha256', 'ubi-interact master keys 1').update(RAW).digest();
    for (const purpose of PURPOSES) {
      const expanded = createHmac('sha256', extracted)
        .update(`ubi-interact ${purpose}`)
        .update(Uint8Array.of(1))
        .digest();
      expect(Buffer.from(deriveKey(RAW, purpose))).toEqual(expanded);
    }
    const keys = PURPOSES.map((purpose) => Buffer.from(deriveKey(RAW, purpose)).toString('hex'));
    expect(new Set(keys).size).toBe(PURPOSES.length);
  });

  it('sign each its own, and the raw one nothing', () => {
    const secrets = new HmacAccessSecrets(RAW);
    expect(new HmacResumeTokens(RAW).issue('x')).toBe(hmac(deriveKey(RAW, 'resume tokens'), 'x'));
    expect(secrets.sign('x')).toBe(hmac(deriveKey(RAW, 'credentials'), 'x'));
    expect(secrets.fingerprint('x')).toBe(hmac(deriveKey(RAW, 'join secrets'), 'x'));
  });
});

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
