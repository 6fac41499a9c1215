import { watch, type FSWatcher } from 'node:fs';

/** Editors write a file in several steps: a look when they are done sees one change. */
const DEBOUNCE_MS = 100;
/** Without notices from the system. */
const RESCAN_MS = 2_000;
/** Beside them: some file systems lose or never send them. */
const RARE_RESCAN_MS = 30_000;

/** Calls `look` soon after something in a folder changed, and now and then anyway. */
export class FolderWatch {
  readonly #look: () => void;
  #interval: NodeJS.Timeout;
  #watcher: FSWatcher | undefined = undefined;
  #timer: NodeJS.Timeout | undefined = undefined;

  constructor(folder: string, look: () => void) {
    this.#look = look;
    this.#interval = this.#every(RARE_RESCAN_MS);
    try {
      this.#watcher = watch(folder, { persistent: false }, () => this.#handleNotice());
      this.#watcher.on('error', () => this.#lookOften());
    } catch {
      this.#lookOften();
    }
  }

  close(): void {
    clearInterval(this.#interval);
    clearTimeout(this.#timer);
    this.#watcher?.close();
  }

  /** Polls folders that cannot be watched. */
  #lookOften(): void {
    this.#watcher?.close();
    clearInterval(this.#interval);
    this.#interval = this.#every(RESCAN_MS);
  }

  #every(intervalMs: number): NodeJS.Timeout {
    return setInterval(this.#look, intervalMs).unref();
  }

  #handleNotice(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(this.#look, DEBOUNCE_MS);
    this.#timer.unref();
  }
}
