import { randomBytes } from 'node:crypto';
import { readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const FILE_NAME = 'admin-token';

/** The file that gives programs of the operator's user the token of the running master. [AC-44] */
export class AdminTokenFile {
  readonly path: string;
  readonly #text: string;

  /**
   * Writes it, for its owner only; what an earlier run left is replaced.
   *
   * @throws Error when it cannot be written
   */
  constructor(dataDir: string, token: string) {
    this.path = join(dataDir, FILE_NAME);
    this.#text = `${token}\n`;
    // Whole from the first moment, and a file of ours: a link in its place is replaced, not followed.
    const draft = `${this.path}.${process.pid}.${randomBytes(4).toString('hex')}`;
    try {
      writeFileSync(draft, this.#text, { mode: 0o600, flag: 'wx' });
      renameSync(draft, this.path);
    } catch (error) {
      rmSync(draft, { force: true });
      throw error;
    }
  }

  /** Removes it, unless another master has written its own since. */
  close(): void {
    try {
      if (readFileSync(this.path, 'utf8') === this.#text) rmSync(this.path);
    } catch {
      // Gone already.
    }
  }
}
