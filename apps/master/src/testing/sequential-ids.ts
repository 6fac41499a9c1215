import { randomIds } from '../adapters/ids/random-ids.ts';
import type { IdSource } from '../core/ports/id-source.ts';

/** Gives 00000000-0000-4000-8000-000000000001, then ...002, and so on. */
export class SequentialIds implements IdSource {
  #count: number;

  /** @param given ids that were given before: for a second run of the master */
  constructor(given = 0) {
    this.#count = given;
  }

  uuid(): string {
    this.#count++;
    return `00000000-0000-4000-8000-${String(this.#count).padStart(12, '0')}`;
  }

  named(name: string): string {
    return randomIds.named(name);
  }
}
