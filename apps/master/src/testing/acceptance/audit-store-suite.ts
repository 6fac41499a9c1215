import { describe, expect, it } from 'vitest';
import type { AuditStore } from '../../core/ports/audit-store.ts';

/**
 * Acceptance tests of audit stores.
 * @param open A store; called again, one of the next run with what the run before kept.
 */
export function auditStoreSuite(name: string, open: () => AuditStore): void {
  describe(`${name}, an AuditStore`, () => {
    it('gives the next run what was kept, in order', async () => {
      const store = open();
      store.append('{"a":1}');
      store.append('{"a":2}');
      await store.settled();
      store.append('{"a":"ä"}');
      await store.settled();
      const next = open();
      expect(next.read().slice(-3)).toEqual(['{"a":1}', '{"a":2}', '{"a":"ä"}']);
      next.append('{"a":4}');
      await next.settled();
      expect(open().read().slice(-2)).toEqual(['{"a":"ä"}', '{"a":4}']);
    });

    it('is settled when nothing was kept', async () => {
      await expect(open().settled()).resolves.toBeUndefined();
    });
  });
}
