import { describe, expect, it } from 'vitest';
import type { Log } from '../../core/ports/log.ts';

/** One line as it was written. */
export interface WrittenLine {
  readonly level: string;
  readonly message: string;
  readonly fields: Readonly<Record<string, unknown>>;
}

/**
 * Acceptance tests of logs.
 * @param createLog A log that writes every level, and a way to read what it wrote.
 */
export function logSuite(
  name: string,
  createLog: () => { readonly log: Log; readonly lines: () => readonly WrittenLine[] },
): void {
  describe(`${name}, a Log`, () => {
    it('writes level, message and fields, in order', () => {
      const { log, lines } = createLog();
      log.error('broken', { count: 1 });
      log.warn('odd', { isOdd: true });
      log.info('up', { name: 'ada' });
      log.debug('detail');
      expect(lines()).toMatchObject([
        { level: 'error', message: 'broken', fields: { count: 1 } },
        { level: 'warn', message: 'odd', fields: { isOdd: true } },
        { level: 'info', message: 'up', fields: { name: 'ada' } },
        { level: 'debug', message: 'detail' },
      ]);
    });

    it('adds the fields of a child, and of its child', () => {
      const { log, lines } = createLog();
      log.child({ part: 'ws' }).child({ clientId: 'ada' }).info('hello', { code: 1 });
      expect(lines()).toMatchObject([{ fields: { part: 'ws', clientId: 'ada', code: 1 } }]);
    });

    it('writes a line for a message of several', () => {
      const { log, lines } = createLog();
      log.info('one\ntwo', { text: 'a\nb' });
      expect(lines()).toHaveLength(1);
    });
  });
}
