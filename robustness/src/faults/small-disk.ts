import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { pause } from '../pause.ts';

/** A disk of its own, in memory. */
export class SmallDisk {
  readonly folder: string;
  readonly #removeWithUs = (): void => this.remove();

  /** Why there can be none here; undefined: there can. */
  static reasonAgainst(): string | undefined {
    if (process.platform !== 'linux') return 'file systems in memory are of Linux';
    if (process.getuid?.() !== 0) return 'mounting takes root';
    try {
      new SmallDisk(1).remove();
      return undefined;
    } catch (error) {
      return `"mount -t tmpfs" failed: ${String((error as Error).message).split('\n')[0]}`;
    }
  }

  /** @throws Error when it cannot be mounted */
  constructor(mebibytes: number) {
    this.folder = mkdtempSync(join(tmpdir(), 'ubii-disk-'));
    mount('-t', 'tmpfs', '-o', `size=${mebibytes}m`, 'ubii-faults', this.folder);
    process.once('exit', this.#removeWithUs);
  }

  /** Takes what is left of it, but for what a page of memory holds. */
  fill(): void {
    const file = join(this.folder, 'filler');
    let text = '';
    for (let size = 1 << 20; size >= 4_096; size /= 2) {
      try {
        for (;;) {
          writeFileSync(file, text + 'f'.repeat(size));
          text += 'f'.repeat(size);
        }
      } catch {
        // As much as this does not fit any more.
        writeFileSync(file, text);
      }
    }
  }

  /** Gives back what `fill` took. */
  empty(): void {
    rmSync(join(this.folder, 'filler'), { force: true });
  }

  /** Waits for what is being written: the system takes nothing away meanwhile. @throws Error after 5 s */
  async setReadOnly(isReadOnly: boolean): Promise<void> {
    const endMs = performance.now() + 5_000;
    for (;;) {
      try {
        mount('-o', `remount,${isReadOnly ? 'ro' : 'rw'}`, this.folder);
        return;
      } catch (error) {
        if (performance.now() > endMs) throw error;
        await pause(20);
      }
    }
  }

  remove(): void {
    process.off('exit', this.#removeWithUs);
    execFileSync('umount', ['-l', this.folder], { stdio: 'pipe' });
    rmSync(this.folder, { recursive: true, force: true });
  }
}

function mount(...args: readonly string[]): void {
  execFileSync('mount', args, { stdio: 'pipe' });
}
