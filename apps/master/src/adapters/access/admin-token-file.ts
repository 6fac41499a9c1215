import { readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { SECRET_MODE, writeAtomicallySync } from '@ubii/program';

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
    writeAtomicallySync(this.path, this.#text, SECRET_MODE);
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
