import { describe, expect, it } from 'vitest';
import type { IdSource } from '../../core/ports/id-source.ts';

/** Acceptance tests of sources of ids. */
export function idSourceSuite(name: string, createIds: () => IdSource): void {
  describe(`${name}, an IdSource`, () => {
    it('gives version 4 UUIDs in lower-case letters', () => {
      expect(createIds().uuid()).toMatch(
        /^[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$/,
      );
    });

    it('never gives one twice', () => {
      const ids = createIds();
      const given = new Set(Array.from({ length: 10_000 }, () => ids.uuid()));
      expect(given.size).toBe(10_000);
    });

    it('gives the same version 5 UUID for the same name, another for each', () => {
      const [one, again, other] = ['circle', 'circle', 'Kreis ⭕'].map((text) =>
        createIds().named(text),
      );
      expect(one).toMatch(/^[0-9a-f]{8}-[0-9a-f]{4}-5[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$/);
      expect(again).toBe(one);
      expect(other).not.toBe(one);
    });
  });
}
