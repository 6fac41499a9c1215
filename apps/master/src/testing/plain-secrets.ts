import type { AccessSecrets } from '../core/ports/access-secrets.ts';

/** Predictable secrets for tests: consecutive numbers, and texts with a prefix. */
export class PlainSecrets implements AccessSecrets {
  static #count = 0;

  token(): string {
    return `token-${++PlainSecrets.#count}-`.padEnd(43, 'x');
  }

  numbers(count: number, below: number): readonly number[] {
    const number = ++PlainSecrets.#count;
    return Array.from({ length: count }, (_, place) => Math.floor(number / below ** place) % below);
  }

  fingerprint(secret: string): string {
    return `hash of ${secret}`;
  }

  sign(text: string): string {
    return Buffer.from(`signed ${text}`).toString('base64url');
  }

  verify(text: string, signature: string): boolean {
    return signature === this.sign(text);
  }
}
