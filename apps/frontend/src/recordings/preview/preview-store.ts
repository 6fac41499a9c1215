import type { WorkerPeer } from '@ubii/worker-rpc/browser';
import { shallowReactive } from 'vue';
import type { ReadableFile } from '../files/readable-file.ts';
import type { PreviewRequest, PreviewWorker, RecordingPreview } from './preview-messages.ts';

/** What is known of a recording in a list. */
export interface PreviewState {
  readonly preview?: RecordingPreview;
  readonly picture?: ImageBitmap | undefined;
  /** Why there is none, one sentence. */
  readonly problem?: string;
}

/** Read at the same time. */
const MAX_RUNNING = 2;
/** Kept, with a picture of 320 pixels across each: about 50 MB. */
const MAX_KEPT = 200;

/** Previews of recordings that are on screen: the last one shown is read first, those shown longest ago go. */
export class PreviewStore {
  readonly #open: () => WorkerPeer<PreviewWorker>;
  #worker: WorkerPeer<PreviewWorker> | undefined;
  readonly #states = shallowReactive(new Map<string, PreviewState>());
  readonly #wishes = new Map<string, ReadableFile>();
  readonly #running = new Set<string>();

  /** @param open starts the worker, when the first preview is asked for */
  constructor(open: () => WorkerPeer<PreviewWorker>) {
    this.#open = open;
  }

  get(key: string): PreviewState | undefined {
    return this.#states.get(key);
  }

  /** A recording is on screen. What failed before is tried again. */
  show({ key, source }: PreviewRequest): void {
    const known = this.#states.get(key);
    if (known !== undefined && known.problem === undefined) {
      this.#keep(key, known);
      return;
    }
    if (this.#running.has(key)) return;
    this.#wishes.set(key, source);
    this.#ask();
  }

  /** It has left the screen: it is not read, unless reading has begun. */
  hide(key: string): void {
    this.#wishes.delete(key);
  }

  close(): void {
    this.#worker?.close();
    this.#wishes.clear();
    for (const { picture } of this.#states.values()) picture?.close();
    this.#states.clear();
  }

  #ask(): void {
    while (this.#running.size < MAX_RUNNING) {
      const wish = [...this.#wishes].at(-1);
      if (wish === undefined) return;
      const [key, source] = wish;
      this.#wishes.delete(key);
      this.#running.add(key);
      void this.#read({ key, source });
    }
  }

  async #read(request: PreviewRequest): Promise<void> {
    const { key } = request;
    try {
      const { calls } = (this.#worker ??= this.#open());
      const preview = await calls.readPreview(request);
      this.#keep(key, { preview });
      if (preview.hasPicture) this.#keep(key, { preview, picture: await calls.readPicture(key) });
    } catch (error) {
      this.#keep(key, { problem: (error as Error).message });
    }
    this.#running.delete(key);
    this.#ask();
  }

  #keep(key: string, state: PreviewState): void {
    if (this.#states.get(key) !== state) this.#states.set(key, state);
    for (const [oldest, { picture }] of this.#states) {
      if (this.#states.size <= MAX_KEPT) return;
      picture?.close();
      this.#states.delete(oldest);
    }
  }
}
