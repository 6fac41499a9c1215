import type { IdSource } from '../core/ports/id-source.ts';

/** Gives 00000000-0000-4000-8000-000000000001, then ...002, and so on. */
export class SequentialIds implements IdSource {
  #count = 0;

  uuid(): string {
    this.#count++;
    return `00000000-0000-4000-8000-${String(this.#count).padStart(12, '0')}`;
  }
}
