import { watch, type FSWatcher } from 'node:fs';

/** Editors write a file in several steps: a look when they are done sees one change. */
const DEBOUNCE_MS = 100;
/** Without notices from the system, and beside them: some file systems lose or never send them. */
const RESCAN_MS = 2_000;

/** Calls `look` soon after something in a folder changed, and now and then anyway. */
export class FolderWatch {
  readonly #look: () => void;
  readonly #interval: NodeJS.Timeout;
  #watcher: FSWatcher | undefined = undefined;
  #timer: NodeJS.Timeout | undefined = undefined;

  constructor(folder: string, look: () => void) {
    this.#look = look;
    this.#interval = setInterval(look, RESCAN_MS);
    this.#interval.unref();
    try {
      this.#watcher = watch(folder, { persistent: false }, () => this.#handleNotice());
      // What cannot be watched is looked at.
      this.#watcher.on('error', () => this.#watcher?.close());
    } catch {
      // The interval does.
    }
  }

  close(): void {
    clearInterval(this.#interval);
    clearTimeout(this.#timer);
    this.#watcher?.close();
  }

  #handleNotice(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(this.#look, DEBOUNCE_MS);
    this.#timer.unref();
  }
}
