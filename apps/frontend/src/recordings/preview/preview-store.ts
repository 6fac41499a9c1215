import { shallowReactive } from 'vue';
import type { ReadableFile } from '../files/readable-file.ts';
import type { PreviewReport, PreviewRequest, RecordingPreview } from './preview-messages.ts';

/** What is known of a recording in a list. */
export interface PreviewState {
  readonly preview?: RecordingPreview;
  readonly picture?: ImageBitmap | undefined;
  /** Why there is none, one sentence. */
  readonly problem?: string;
}

/** The worker that reads previews. */
export interface PreviewPort {
  send(request: PreviewRequest): void;
  onReport(handle: (report: PreviewReport) => void): void;
  close(): void;
}

/** Read at the same time. */
const MAX_RUNNING = 2;
/** Kept, with a picture of 320 pixels across each: about 50 MB. */
const MAX_KEPT = 200;

/** Previews of recordings that are on screen: the last one shown is read first, those shown longest ago go. */
export class PreviewStore {
  readonly #open: () => PreviewPort;
  #port: PreviewPort | undefined;
  readonly #states = shallowReactive(new Map<string, PreviewState>());
  readonly #wishes = new Map<string, ReadableFile>();
  readonly #running = new Set<string>();

  /** @param open starts the worker, when the first preview is asked for */
  constructor(open: () => PreviewPort) {
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
    this.#port?.close();
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
      this.#worker().send({ key, source });
    }
  }

  #worker(): PreviewPort {
    if (this.#port === undefined) {
      this.#port = this.#open();
      this.#port.onReport((report) => this.#take(report));
    }
    return this.#port;
  }

  #take(report: PreviewReport): void {
    const { key } = report;
    const known = this.#states.get(key);
    if (report.kind === 'preview') this.#keep(key, { preview: report.preview });
    else if (report.kind === 'picture') this.#keep(key, { ...known, picture: report.picture });
    else this.#keep(key, { problem: report.message });
    if (report.kind === 'preview' && report.preview.hasPicture) return;
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
