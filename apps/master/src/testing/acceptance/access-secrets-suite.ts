import { expect, it } from 'vitest';
import type { AccessSecrets } from '../../core/ports/access-secrets.ts';

/** Properties that the core relies on. @param create returns the same secrets for the same `key` */
export function accessSecretsSuite(create: (key: number) => AccessSecrets): void {
  it('creates unique tokens that cannot be guessed', () => {
    const secrets = create(1);
    const tokens = new Set(Array.from({ length: 100 }, () => secrets.token()));
    expect(tokens.size).toBe(100);
    for (const token of tokens) expect(token).toMatch(/^[\w-]{22,}$/);
  });

  it('makes numbers below a bound, all of them', () => {
    const numbers = create(1).numbers(2_000, 32);
    expect(new Set(numbers)).toEqual(new Set(Array.from({ length: 32 }, (_, i) => i)));
  });

  it('hashes the same secret the same way in another run, and without the key otherwise', () => {
    const hash = create(1).fingerprint('a');
    expect(create(1).fingerprint('a')).toBe(hash);
    expect(create(1).fingerprint('b')).not.toBe(hash);
    expect(create(2).fingerprint('a')).not.toBe(hash);
  });

  it('proves what it signed, in another run too, and nothing else', () => {
    const signature = create(1).sign('a');
    expect(create(1).verify('a', signature)).toBe(true);
    expect(create(1).verify('b', signature)).toBe(false);
    expect(create(2).verify('a', signature)).toBe(false);
    for (const wrong of [
      '',
      'x',
      `${signature}x`,
      signature.slice(1),
      '\u0000',
      create(1).fingerprint('a'),
    ]) {
      expect(create(1).verify('a', wrong)).toBe(false);
    }
  });
}
