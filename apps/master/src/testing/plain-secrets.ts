import type { AccessSecrets } from '../core/ports/access-secrets.ts';

/** Predictable secrets for tests: consecutive numbers, and texts with a prefix. */
export class PlainSecrets implements AccessSecrets {
  static #count = 0;

  token(): string {
    return `token-${++PlainSecrets.#count}-`.padEnd(43, 'x');
  }

  /** The last is the largest: as a code, it is in no id of a test. */
  numbers(count: number, below: number): readonly number[] {
    const number = ++PlainSecrets.#count;
    const digit = (place: number): number => Math.floor(number / below ** place) % below;
    return Array.from({ length: count }, (_, place) =>
      place === count - 1 ? below - 1 : digit(place),
    );
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
