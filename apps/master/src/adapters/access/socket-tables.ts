import { close, existsSync, open, read } from 'node:fs';

/** A table of TCP sockets, named after its file in `/proc/net`. */
export type SocketTable = 'tcp' | 'tcp6';

/**
 * Reads a table as Linux writes it.
 *
 * @param take takes the next lines, whole ones; returns whether to go on
 * @returns rejects when the table cannot be read
 */
export type ReadSocketTable = (
  table: SocketTable,
  take: (lines: string) => boolean,
) => Promise<void>;

/** Of the processors that Linux runs on. */
const LARGEST_PAGE_BYTES = 65_536;

/** The tables of this system; undefined where there are none. */
export function systemTables(): ReadSocketTable | undefined {
  return process.platform === 'linux' && existsSync('/proc/net/tcp') ? readTable : undefined;
}

/**
 * The system delivers a page at a time, and a table may have hundreds. Callbacks, because a promise of the
 * file system for each costs more than the system needs for the page.
 */
function readTable(table: SocketTable, take: (lines: string) => boolean): Promise<void> {
  return new Promise((resolve, reject) => {
    open(`/proc/net/${table}`, 'r', (failed, file) => {
      if (failed !== null) return reject(failed);
      readPages(file, take, (error) => {
        close(file, () => (error === null ? resolve() : reject(error)));
      });
    });
  });
}

/** @param done called once, when `take` has enough or the file ends */
function readPages(
  file: number,
  take: (lines: string) => boolean,
  done: (error: Error | null) => void,
): void {
  const page = Buffer.allocUnsafe(LARGEST_PAGE_BYTES);
  let begun = '';
  const readNext = (): void => {
    read(file, page, 0, page.length, null, (error, byteLength) => {
      if (error !== null || byteLength === 0) return done(error);
      const text = begun + page.toString('latin1', 0, byteLength);
      const end = text.lastIndexOf('\n') + 1;
      begun = text.slice(end);
      if (take(text.slice(0, end))) readNext();
      else done(null);
    });
  };
  readNext();
}
